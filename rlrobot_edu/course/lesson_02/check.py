"""Exercises of lesson 02: Q-learning."""

from __future__ import annotations

from rlrobot_edu.course.grading.exercise import Exercise, Mistake, Question
from rlrobot_edu.course.grading.tapes import Q_START, TAPE, TapeWorld

by_hand = Question(
    task="the new Q(s, a), computed by hand",
    right=5.05,
    because="4 + 0.1 · (10 + 0.9 · 5 − 4) = 5.05: one tenth of the way from 4 to the target of 14.5.",
    mistakes=[
        Mistake("this is the target itself. With α = 0.1, Q goes only a tenth of the way towards it.", 14.5),
        Mistake("you forgot γ: the value of the next state counts 0.9 times.", 5.1),
        Mistake("you added α times the target. The TD error is the target minus the old Q(s, a).", 5.45),
        Mistake("the next state counts, too: add γ times its best value to the reward.", 4.6),
        Mistake("this is the TD error δ. The new Q(s, a) is the old one plus α · δ.", 10.5),
        Mistake("this is the step α · δ. Add it to the old Q(s, a).", 1.05),
        Mistake("from the next state its best action counts: 5, not 3.7.", 4.933),
        Mistake("from the next state its best action counts: 5, not −1.", 4.51),
        Mistake("from the next state its best action counts: 5, not the mean.", 4.831),
    ],
)


def _target(q, r, s_next, terminated, gamma):
    return r if terminated else r + gamma * q[s_next].max()


target = Exercise(
    task="return what Q(s, a) should have been, r + γ · max Q(s', ·)",
    right=_target,
    returns="target",
    tape=[{"q": Q_START, "gamma": 0.9} | {name: row[name] for name in ("r", "s_next", "terminated")} for row in TAPE],
    mistakes=[
        Mistake(
            "this bootstraps past the end. After a terminal step nothing follows, so the target is the reward alone.",
            lambda q, r, s_next, terminated, gamma: r + gamma * q[s_next].max(),
        ),
        Mistake(
            "you forgot γ, which makes later rewards count less.",
            lambda q, r, s_next, terminated, gamma: r + (0 if terminated else q[s_next].max()),
        ),
        Mistake(
            "this is what action 0 is worth in s', not what the best action is worth.",
            lambda q, r, s_next, terminated, gamma: r + (0 if terminated else gamma * q[s_next, 0]),
        ),
        Mistake(
            "argmax tells which action is best; the target needs how much it is worth. That is max.",
            lambda q, r, s_next, terminated, gamma: r + (0 if terminated else gamma * q[s_next].argmax()),
        ),
        Mistake(
            "this is the mean over the actions of s'. Q-learning assumes that the best one will be taken.",
            lambda q, r, s_next, terminated, gamma: r + (0 if terminated else gamma * q[s_next].mean()),
        ),
        Mistake(
            "this is the best value in the whole table. Only the row of s' counts.",
            lambda q, r, s_next, terminated, gamma: r + (0 if terminated else gamma * q.max()),
        ),
        Mistake(
            "γ discounts what comes later; the reward of this step counts in full.",
            lambda q, r, s_next, terminated, gamma: gamma * (r + (0 if terminated else q[s_next].max())),
        ),
    ],
)


def _update(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (_target(q, r, s_next, terminated, gamma) - q[s, a])


def _bootstraps_past_the_end(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + gamma * q[s_next].max() - q[s, a])


def _forgets_gamma(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (_target(q, r, s_next, terminated, 1.0) - q[s, a])


def _forgets_old_value(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * _target(q, r, s_next, terminated, gamma)


def _replaces(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = alpha * (_target(q, r, s_next, terminated, gamma) - q[s, a])


def _jumps(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] = _target(q, r, s_next, terminated, gamma)


def _updates_the_next_state(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s_next, a] += alpha * (_target(q, r, s_next, terminated, gamma) - q[s_next, a])


def _updates_the_row(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s] += alpha * (_target(q, r, s_next, terminated, gamma) - q[s])


def _looks_at_its_own_state(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (_target(q, r, s, terminated, gamma) - q[s, a])


def _takes_the_same_action_again(q, s, a, r, s_next, terminated, alpha, gamma):
    q[s, a] += alpha * (r + (0.0 if terminated else gamma * q[s_next, a]) - q[s, a])


def _changes_nothing(q, s, a, r, s_next, terminated, alpha, gamma):
    return q[s, a] + alpha * (_target(q, r, s_next, terminated, gamma) - q[s, a])


update = Exercise(
    task="change q[s, a] by α times the TD error",
    right=_update,
    memory={"q": Q_START},
    tape=[row | {"alpha": 0.1, "gamma": 0.9} for row in TAPE],
    mistakes=[
        Mistake(
            "this bootstraps past the end. After a terminal step nothing follows, so the target is the reward alone.",
            _bootstraps_past_the_end,
        ),
        Mistake("you forgot γ, which makes later rewards count less.", _forgets_gamma),
        Mistake(
            "the TD error is the target minus the old q[s, a]; here the old value is not taken off.", _forgets_old_value
        ),
        Mistake("q[s, a] should change by α · δ. You replaced it: write += instead of =.", _replaces),
        Mistake("q[s, a] jumps to the target. It should go only the share α of the way.", _jumps),
        Mistake("the pair that learns is (s, a), where the step began, not s'.", _updates_the_next_state),
        Mistake("only the action that was taken learns: change q[s, a], not the whole row q[s].", _updates_the_row),
        Mistake("the value of what follows is that of the next state s', not of s.", _looks_at_its_own_state),
        Mistake("in s' the best action counts, not the old action a once more.", _takes_the_same_action_again),
        Mistake(
            "the table is as it was. Write the new value into q[s, a]; to return it is not enough.", _changes_nothing
        ),
    ],
)


def _loop(slip: str = ""):
    """The loop with one slip in it; without one it is right."""

    def learn(env, q, choose, update, steps):
        if slip != "always resets":
            s = env.reset()
        for _ in range(steps):
            if slip == "always resets":
                s = env.reset()
            a = choose(q, s)
            s_next, r, terminated, truncated = env.step(a)
            over = terminated or truncated
            if slip == "moves on first":
                s = s_next
            if not (over and slip == "skips the last step"):
                update(q, s, a, r, s_next, over if slip == "takes truncated for terminated" else terminated)
            if slip != "stays":
                s = s_next
            if over and slip == "stops":
                break
            if {"never resets": False, "misses truncated": terminated}.get(slip, over):
                s = env.reset()

    return learn


def _best(q, s):
    return int(q[s].argmax())


def _library_update(q, s, a, r, s_next, terminated):
    _update(q, s, a, r, s_next, terminated, 0.1, 0.9)


learn = Exercise(
    task="choose, step, update, and go on from the next state, or from a reset where an episode has ended",
    right=_loop(),
    memory={"env": TapeWorld(), "q": Q_START},
    tape=[{"choose": _best, "update": _library_update, "steps": n} for n in (1, 2, 4, 9)],
    mistakes=[
        Mistake("after the end of an episode the world must be reset, which gives a new s.", _loop("never resets")),
        Mistake("the next step starts where this one ended: you forgot s = s_next.", _loop("stays")),
        Mistake(
            "truncated only means that time is up: the world goes on, so the target keeps its second part. "
            "Hand terminated alone to update.",
            _loop("takes truncated for terminated"),
        ),
        Mistake("an episode also ends when it is truncated. Reset then, too.", _loop("misses truncated")),
        Mistake("s has become s_next before the update. Update first, move on afterwards.",
                _loop("moves on first")),
        Mistake("reset belongs before the loop, and where an episode ends; here every step starts anew.",
                _loop("always resets")),
        Mistake("at the end of an episode the loop should go on with a new one until all steps are done.",
                _loop("stops")),
        Mistake("the last step of an episode teaches something, too: update first, then reset.",
                _loop("skips the last step")),
    ],
)  # fmt: skip

look_ahead = Question(
    task="the discount rate γ with which a reward ten steps ahead counts one half",
    right=0.5 ** (1 / 10),
    because="0.933 to the power of 10 is one half. A rule of thumb: γ looks about 1 / (1 − γ) steps ahead, here 15.",
    mistakes=[
        Mistake("with γ = 0.5 a reward halves at every step: ten steps ahead it counts 0.001 times.", 0.5),
        Mistake("this is 0.5 / 10. Discounting multiplies: γ · γ · … · γ, ten times, must be one half.", 0.05),
        Mistake("this takes 0.05 off at each step. Discounting multiplies: 0.95 to the power of 10 is 0.6.", 0.95),
        Mistake("this is 0.5 to the power of 10. You want the opposite, the tenth root of 0.5.", 0.5**10),
        Mistake("with γ = 0.9 it counts 0.35 times: too little.", 0.9),
        Mistake("nearly: 0.93 to the power of 10 is 0.48. Give three digits.", 0.93),
        Mistake("this is the fourth root of 0.5, as in the hint's example. You need the tenth.", 0.5**0.25),
        Mistake("this is 10 to the power of 0.5, the square root of 10. You have swapped base and exponent.", 10**0.5),
    ],
)
