"""A heap of pairs, the most urgent on top: an array in which none is more urgent than the one above it.

The pair in place i stands below the one in place (i − 1) // 2; `place` says where each pair is, −1 where it is not.
Source: Cormen, Leiserson, Rivest & Stein, *Introduction to Algorithms*, chapter 6.
"""

from rlrobot_edu.learning.jit import compiled


@compiled
def rise(x, i):
    """Let the pair in place `i` change with the one above it as long as that is less urgent."""
    pair = x.heap[i]
    while i > 0 and x.urgency[x.heap[(i - 1) // 2]] < x.urgency[pair]:
        x.heap[i] = x.heap[(i - 1) // 2]
        x.place[x.heap[i]] = i
        i = (i - 1) // 2
    x.heap[i] = pair
    x.place[pair] = i


@compiled
def sink(x, i):
    """Let the pair in place `i` change with the more urgent of the two below as long as that is more urgent."""
    pair, n = x.heap[i], x.now.urgent
    while 2 * i + 1 < n:
        below = 2 * i + 1
        if below + 1 < n and x.urgency[x.heap[below + 1]] > x.urgency[x.heap[below]]:
            below += 1
        if x.urgency[x.heap[below]] <= x.urgency[pair]:
            break
        x.heap[i] = x.heap[below]
        x.place[x.heap[i]] = i
        i = below
    x.heap[i] = pair
    x.place[pair] = i


@compiled
def put(x, pair):
    """Put `pair` where its urgency belongs, whether it is in the heap or not."""
    if x.place[pair] < 0:
        x.place[pair] = x.now.urgent
        x.heap[x.now.urgent] = pair
        x.now.urgent += 1
    rise(x, x.place[pair])
    sink(x, x.place[pair])


@compiled
def pop(x):
    """Take the most urgent pair out of the heap, which must not be empty."""
    pair, x.now.urgent = x.heap[0], x.now.urgent - 1
    x.place[pair] = -1
    if x.now.urgent > 0:
        x.heap[0] = x.heap[x.now.urgent]
        sink(x, 0)
    return pair
