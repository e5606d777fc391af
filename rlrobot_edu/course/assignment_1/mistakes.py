"""The typical wrong answers to the exercises of assignment 1, each an edit of the right one."""

from rlrobot_edu.course.grading.mistake import Mistake

PAST_THE_END = "this looks past the end. After a terminated step nothing follows, so the target is the reward alone."
NO_GAMMA = "γ is missing: what comes a step later counts γ times."
TARGET = "r if terminated else r + gamma * max(q[s_next])"

STATE_OF = [
    Mistake("k cuts make k + 1 bins, so each cell has k + 1 states. Yours have k, and two states share a number.",
            {"(len(cuts) + 1)": "len(cuts)"}),
    Mistake("on a cut point counts as below it: a bin ends with its cut. Compare with >.",
            {"voltage > cut": "voltage >= cut"}),
    Mistake("the bins are the wrong way round: the bin is how many cuts lie below the voltage.",
            {"voltage > cut": "voltage <= cut"}),
    Mistake("bins are numbered from 0: below all cuts is bin 0.", {"for cut in cuts)": "for cut in cuts) + 1"}),
    Mistake("cell and bin are only added, so many pairs share a number. Each cell needs a block of states.",
            {"cell * (len(cuts) + 1)": "cell"}),
    Mistake("the cell is missing: the same voltage in another cell is another state.",
            {"cell * (len(cuts) + 1) + charge": "charge"}),
    Mistake("here the bin counts most. The cell should: cell times the number of bins, plus the bin.",
            {"cell * (len(cuts) + 1) + charge": "charge * (len(cuts) + 1) + cell"}),
    Mistake("the sum adds voltages up. Count the cuts that lie below the voltage.",
            {"voltage > cut for": "cut * (voltage > cut) for"}),
    Mistake("the bin is missing: the same cell with another charge is another state.", {" + charge": ""}),
]  # fmt: skip

RETURNS = [
    Mistake("the day has several episodes: where one ends, nothing of the next counts any more.",
            {"if ends[t]:": "if False:"}),
    Mistake(NO_GAMMA, {"gamma * ": ""}),
    Mistake("the reward of the step at which an episode ends counts in full: 0 is what follows it, not its return.",
            {"g[t] = rewards[t] + gamma * follows": "g[t] = 0.0 if ends[t] else rewards[t] + gamma * follows"}),
    Mistake("γ discounts what follows; the reward of the step itself counts in full.",
            {"rewards[t] + gamma * follows": "gamma * (rewards[t] + follows)"}),
    Mistake("this goes from the morning on: so it adds what has been, and a return is of what is to come.",
            {"range(len(rewards) - 1, -1, -1)": "range(len(rewards))"}),
    Mistake("these are the rewards. A return adds what follows, γ times.",
            {" + gamma * follows": ""}),
    Mistake("ends[t] says that step t is the last of its episode. You let what follows be 0 one step too early.",
            {"if ends[t]:": "if t + 1 < len(ends) and ends[t + 1]:"}),
    Mistake("only the next reward is added. What follows is the next return, which holds all that is still to come.",
            {"follows = g[t]": "follows = rewards[t]"}),
    Mistake("follows is 0 for good after the first end. Set it to 0 only at an end, and to g[t] after each step.",
            {"follows = g[t]": "follows = 0.0 if any(ends[t:]) else g[t]"}),
]  # fmt: skip

REPLAY = [
    Mistake("this begins with the first step. Begin with the last: then each step sees what the next has learned.",
            {"reversed(log)": "log"}),
    Mistake(PAST_THE_END, {TARGET: "r + gamma * max(q[s_next])"}),
    Mistake(NO_GAMMA, {"gamma * ": ""}),
    Mistake("a part of the way is α: change q[s, a] by α times the TD error.", {"alpha * (": "("}),
    Mistake("the TD error is the target minus the old q[s, a].", {"(target - q[s, a])": "target"}),
    Mistake("this is always the reward alone. Unless the step is terminated, the best of s' counts, too.",
            {TARGET: "r"}),
    Mistake("if is the wrong way round: the reward stands alone where the episode has ended.",
            {"if terminated": "if not terminated"}),
    Mistake("a terminated step has a target, too, its reward. Learn from it as from the others.",
            {"q[s, a] +=": "q[s, a] += 0 if terminated else"}),
    Mistake("this takes the mean over the actions of s'. Q-learning assumes the best one.",
            {"max(q[s_next])": "q[s_next].mean()"}),
    Mistake("all steps of the log are to be learned from, the last, too.", {"reversed(log)": "reversed(log[:-1])"}),
    Mistake("all steps of the log are to be learned from, the first, too.", {"reversed(log)": "reversed(log[1:])"}),
    Mistake("this stops at the first end that it meets. Learn from the whole log.",
            {"target = r": "if terminated and (s, a) != log[-1][:2]: break\n        target = r"}),
]  # fmt: skip

GREEDY = [
    Mistake("the best actions share 1: where two are best, each gets 1/2.",
            {"best / best.sum(axis=1, keepdims=True)": "best * 1.0"}),
    Mistake("argmax marks the first of several best actions. All of them are best: compare with the largest value.",
            {"best = q == np.max(q, axis=1, keepdims=True)": "best = np.eye(q.shape[1])[q.argmax(axis=1)]"}),
    Mistake("this compares with the largest value of the whole table. Each state has its own best: axis=1.",
            {"np.max(q, axis=1, keepdims=True)": "q.max()",
             "best.sum(axis=1, keepdims=True)": "best.sum(axis=1, keepdims=True).clip(1)"}),
    Mistake("axis=0 goes down a column, one action in all states. A state is a row: axis=1.",
            {"max(q, axis=1": "max(q, axis=0", "best.sum(axis=1, keepdims=True)":
             "best.sum(axis=1, keepdims=True).clip(1)"}),
    Mistake("these are the worst actions of each state: max, not min.", {"np.max": "np.min"}),
    Mistake("each state has probabilities of its own, that sum to 1 in each row. Divide by the sum of the row.",
            {"best.sum(axis=1, keepdims=True)": "best.sum()"}),
    Mistake("a greedy policy gives every action that is not best the probability 0.",
            {"return best / best.sum(axis=1, keepdims=True)":
             "x = np.exp(q - q.max(axis=1, keepdims=True))\n    return x / x.sum(axis=1, keepdims=True)"}),
]  # fmt: skip

TRAIN = [
    Mistake(PAST_THE_END, {TARGET: "r + gamma * max(q[s_next])"}),
    Mistake("a truncated episode has only run out of time: its last target keeps γ · max Q(s', ·).",
            {"r if terminated else": "r if terminated or truncated else"}),
    Mistake("an episode is over when it is truncated, too.", {"terminated or truncated": "terminated"}),
    Mistake("each episode has its own sum: set it back to 0 when one begins.",
            {"s, total, over = env.reset(), 0.0, False":
             "s, total, over = env.reset(), sums[-1] if sums else 0.0, False"}),
    Mistake("the world is reset once an episode, before its first step.",
            {"for _ in range(episodes):\n        s, total, over = env.reset(), 0.0, False":
             "s = env.reset()\n    for _ in range(episodes):\n        total, over = 0.0, False"}),
    Mistake("the reward of an episode's last step counts in its sum, too.",
            {"total + r,": "total + r * (not (terminated or truncated)),"}),
    Mistake("the sums here are not discounted: add the rewards as they are.", {"total + r": "gamma * total + r"}),
    Mistake("s stays where it was: go on from s_next.", {"s, total, over = s_next,": "s, total, over = s,"}),
    Mistake("the action is chosen once and kept. Choose anew in each step, inside the inner loop.",
            {"env.reset(), 0.0, False\n": "env.reset(), 0.0, False\n        a = choose(q, s)\n",
             "            a = choose(q, s)\n": ""}),
    Mistake("the last sum alone is returned. Keep one sum for each episode, in a list.",
            {"return sums": "return sums[-1]"}),
    Mistake(NO_GAMMA, {"gamma * max": "max"}),
    Mistake("α is missing: go that share of the way, not the whole.", {"alpha * (": "("}),
]  # fmt: skip
