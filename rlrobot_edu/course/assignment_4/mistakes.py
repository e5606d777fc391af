"""The typical wrong answers to the exercises of assignment 4, each an edit of the right one."""

from rlrobot_edu.course.grading.mistake import Mistake

NEAR = [
    Mistake("a circle has no ends: beside its last bin lies its first.",
            {"            if is_circle[i]:\n                other[i] %= shape[i]\n": ""}),
    Mistake("only an input that is a circle goes round. On a line nothing lies beyond the last bin.",
            {"if is_circle[i]:": "if True:"}),
    Mistake("the state itself is not beside itself.", {"sorted(near - {s})": "sorted(near | {s})"}),
    Mistake("beside a bin lie two, the one below and the one above it.", {"(-1, 1)": "(1,)"}),
    Mistake("these are all that share every input but one. Here that one may differ by a single bin only.",
            {"for step in (-1, 1)": "for step in range(-max(shape), max(shape))"}),
    Mistake("only the last input changes. Each of them may, one at a time.",
            {"for i in range(len(shape))": "for i in [len(shape) - 1]"}),
    Mistake("the last input's neighbours are missing.", {"range(len(shape))": "range(len(shape) - 1)"}),
    Mistake("each state once: in a circle of two bins the one below is the one above. A set keeps each once.",
            {"near, bins = set(), ": "near, bins = [], ", "near.add(": "near.append(",
             "sorted(near - {s})": "sorted(near)"}),
    Mistake("several inputs change at once: begin with the bins of s for each neighbour.",
            {"near, bins = set(), np.unravel_index(s, shape)":
             "near, other = set(), list(np.unravel_index(s, shape))",
             "            other = list(bins)\n": ""}),
]  # fmt: skip

BIAS = [
    Mistake("this is the sum over the inputs. The bias is their mean: divide by their number.",
            {"total / len(shape)": "total"}),
    Mistake("this adds up all states that share the other inputs. It is their mean.", {"table.mean": "table.sum"}),
    Mistake("this is the mean of all states, whatever they share.",
            {"table.mean(axis=i, keepdims=True)": "q.mean(axis=0)"}),
    Mistake("Q itself is added, too. The bias is apart from it: who chooses adds the two.",
            {".reshape(q.shape)": ".reshape(q.shape) + q"}),
    Mistake("the last axis is that of the actions. Each action has its own bias.",
            {"range(len(shape))": "range(1, len(shape) + 1)"}),
    Mistake("only the first input is looked at. Each of them has its own states that share the others.",
            {"range(len(shape))": "[0] * len(shape)"}),
    Mistake("the largest value is taken. The bias is a mean.", {"table.mean": "table.max"}),
    Mistake("along axis i this leaves all inputs but i out. Only input i is averaged over.",
            {"table.mean(axis=i,":
             "table.mean(axis=tuple(k for k in range(len(shape)) if k != i),"}),
]  # fmt: skip

PERIOD = [
    Mistake("this is the longest one. The robot goes round once in the shortest: begin with 1.",
            {"range(1, len(states) // 2 + 1)": "range(len(states) // 2, 0, -1)"}),
    Mistake("the newest states count, those at the end of the list. This compares the oldest.",
            {"states[-p:] == states[-2 * p : -p]": "states[:p] == states[p : 2 * p]"}),
    Mistake("a state that comes again is not yet a circle: all of the last p states must be as the p before.",
            {"states[-p:] == states[-2 * p : -p]": "states[-1] == states[-1 - p]"}),
    Mistake("a circle may also be of half the list's length: let p run up to len(states) // 2.",
            {"// 2 + 1": "// 2"}),
    Mistake("only the shortest circles are tried: let p run up to len(states) // 2.",
            {"len(states) // 2 + 1": "min(3, len(states) // 2) + 1"}),
    Mistake("a single state, again and again, is a circle of period 1. Begin with 1.", {"range(1,": "range(2,"}),
    Mistake("where nothing repeats, return 0.", {"return 0": "return len(states)"}),
    Mistake("where nothing repeats, return 0: yours returns nothing there.", {"return 0": "return None"}),
    Mistake("a circle has an order. The same states in another one are no circle.",
            {"states[-p:] == states[-2 * p : -p]": "sorted(states[-p:]) == sorted(states[-2 * p : -p])"}),
    Mistake("this is true or false. Return the period, how many states the circle has.", {"return p": "return True"}),
]  # fmt: skip

TEMPERATURE = [
    Mistake("a circle that pays is no trap: it heats up only where the rewards of the last round sum to less than 0.",
            {" and sum(rewards[-p:]) < 0": ""}),
    Mistake("a round that earns exactly 0 is not below 0.", {"< 0": "<= 0"}),
    Mistake("only the rewards of the last round count, the last p.", {"rewards[-p:]": "rewards"}),
    Mistake("it never gets hotter than 50: take the smaller one.", {"min(50, temperature + len(states) / (4 * p))":
                                                                    "temperature + len(states) / (4 * p)"}),
    Mistake("what is added stands on top of the temperature there is.",
            {"temperature + len(states)": "default + len(states)"}),
    Mistake("outside a circle the temperature goes back to default at once.", {"return default": "return temperature"}),
    Mistake("n / (4 p): the 4 is missing.", {"(4 * p)": "p"}),
    Mistake("brackets: n / (4 p) divides by p, and yours multiplies by it.", {"(4 * p)": "4 * p"}),
    Mistake("the shorter the circle the hotter: p stands below the line.",
            {"len(states) / (4 * p)": "p / 4"}),
    Mistake("without a circle nothing heats up, however little is earned.",
            {"p > 0 and sum(rewards[-p:]) < 0": "sum(rewards[-p:]) < 0",
             "(4 * p)": "max(4 * p, 4)"}),
]  # fmt: skip

DRIVE = [
    Mistake("the bias plays no part: what softmax gets is Q plus bias, times the scale.",
            {" + bias_table(q, shape)[s]": ""}),
    Mistake("Q itself plays no part: what softmax gets is Q plus bias, times the scale.", {"q[s] + bias": "bias"}),
    Mistake("the scale is missing: what softmax gets is scale · (Q + bias).", {"scale * (": "("}),
    Mistake("the scale multiplies both, Q and bias: mind the brackets.",
            {"scale * (q[s] + bias_table(q, shape)[s])": "scale * q[s] + bias_table(q, shape)[s]"}),
    Mistake("the target looks past the end. After a terminated step it is the reward alone.",
            {"r if terminated else": ""}),
    Mistake("the bias is advice for choosing. It has no place in the target: learn from q as it is.",
            {"max(q[s_next])": "max((q + bias_table(q, shape))[s_next])"}),
    Mistake("the temperature never changes: ask next_temperature after each step.",
            {"        temperature = next_temperature(temperature, states, rewards, default)\n": ""}),
    Mistake("after the end of an episode the robot stands elsewhere: clear the states, the rewards and the "
            "temperature.", {"s, states, rewards, temperature = env.reset(), [], [], default": "s = env.reset()"}),
    Mistake("the states are remembered for too long: the last 8 alone.",
            {"[*states, s_next][-8:], [*rewards, r][-8:]": "[*states, s_next], [*rewards, r]"}),
    Mistake("remembered are the states that are reached: s_next, not s.", {"[*states, s_next]": "[*states, s]"}),
    Mistake("the temperature is not handed to the draw.", {"draw(x, temperature, u)": "draw(x, default, u)"}),
    Mistake("a truncated step has only run out of time: its target keeps γ · max Q(s', ·).",
            {"r if terminated else": "r if terminated or truncated else"}),
    Mistake("after a truncated episode the world must be reset, too.", {"if terminated or truncated": "if terminated"}),
    Mistake("all rewards are asked for, one for each u; yours are the last 8.",
            {"return earned, heat": "return rewards, heat"}),
    Mistake("the temperatures are those at which the actions were chosen: note it before it changes.",
            {"        heat.append(temperature)\n": "",
             "        s = s_next\n": "        heat.append(temperature)\n        s = s_next\n"}),
    Mistake("the temperature of the next step comes from the one before: temperature, not default, goes in first.",
            {"next_temperature(temperature,": "next_temperature(default,"}),
]  # fmt: skip
