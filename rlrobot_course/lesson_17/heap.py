"""A heap of pairs, the highest priority on top: an array in which no pair has a higher one than the pair above it.

The pair in place i stands below the one in place (i − 1) // 2; `place` says where each pair is, −1 where it is not.
`n` is a named tuple of arrays, see `Notes`: `priority`, `heap` and `place`, an entry a pair; `waiting`, one number.
Source: Cormen, Leiserson, Rivest & Stein, *Introduction to Algorithms*, chapter 6.
"""

from rlrobot_edu.jit.dispatcher import compiled


@compiled
def rise(n, i):
    """Swap the pair in place `i` with the one above it as long as its priority is higher."""
    pair = n.heap[i]
    while i > 0 and n.priority[n.heap[(i - 1) // 2]] < n.priority[pair]:
        n.heap[i] = n.heap[(i - 1) // 2]
        n.place[n.heap[i]] = i
        i = (i - 1) // 2
    n.heap[i] = pair
    n.place[pair] = i


@compiled
def sink(n, i):
    """Swap the pair in place `i` with the higher of the two below as long as that one is higher than itself."""
    pair, size = n.heap[i], n.waiting[0]
    while 2 * i + 1 < size:
        below = 2 * i + 1
        if (
            below + 1 < size
            and n.priority[n.heap[below + 1]] > n.priority[n.heap[below]]
        ):
            below += 1
        if n.priority[n.heap[below]] <= n.priority[pair]:
            break
        n.heap[i] = n.heap[below]
        n.place[n.heap[i]] = i
        i = below
    n.heap[i] = pair
    n.place[pair] = i


@compiled
def put(n, pair):
    """Put `pair` where its priority belongs, whether it is in the heap or not."""
    if n.place[pair] < 0:
        n.place[pair] = n.waiting[0]
        n.heap[n.waiting[0]] = pair
        n.waiting[0] += 1
    rise(n, n.place[pair])
    sink(n, n.place[pair])


@compiled
def pop(n):
    """Take the pair of highest priority out of the heap, which must not be empty."""
    pair = n.heap[0]
    n.waiting[0] -= 1
    n.place[pair] = -1
    if n.waiting[0] > 0:
        n.heap[0] = n.heap[n.waiting[0]]
        sink(n, 0)
    return pair
