"""What the exercises of all lessons share.

Read in this order:

- `verdict`: what a check says to the learner, a `Verdict`: waiting, right or wrong, the first wrong step and a hint.
- `exercise`: `Question` (the answer is a value) and `Exercise` (the answer is a function: a tape of arguments is
  replayed on it, step by step, beside the right function), each with its list of `Mistake`.
- `design`: `Design`, an exercise in which a reward is designed and tried on pairs of situations.
- `source`: `edited`, which makes a wrong function of the right one, as ``{"max(q[s_next])": "q[s_next].mean()"}`` says.
- `errors`: what may lie behind an exception, by its text (`error_meanings`) and by its frames (`frames`).
- `suspicions`: what is wrong with an answer that shows no known mistake.
- `values`: when two values count as the same, how they differ, how they are shown.
- `tapes`: experience without chance for exercises to replay, `TAPE` and `TapeWorld`; and a task's robot, `RobotWorld`.

An exercise in five lines, with the solution that stands in a file of its own::

    def redundancy(states):
        return len(states) / len(set(states))

    check = Exercise(
        task="return how many states are in the queue for each different one among them",
        right=redundancy, returns="redundancy", tape=[{"states": [5, 7, 5, 7]}, {"states": [5, 7, 5]}],
        mistakes=[Mistake("// cuts off what comes after the point; divide with /.", {"/": "//"})],
    )
    check(learners_function)

A wrong answer is recognised by what it computes, not by how it is written: the hint is that of the mistake which agrees
with it for the most steps. So the tape needs steps in which every mistake shows, and each in a step of its own.
"""
