"""What docs/studies/how_much_tuning.md says around its numbers. People wrote the verdicts, after looking."""

VERDICT = """\
TODO"""

PAGE = """\
# How much tuning does the method need?

The paper promises one method with one setting for many tasks, TOSL+QBIASSR, "with minimal per-task tuning or none". Is
its setting a good one for all of them? Does the bias spare us the tuning?

## In short

{verdict}

{hold} of seven hypotheses hold. They were registered: the design, the hypotheses and [their
tests](../../studies/how_much_tuning_tests.py) were [committed](../../studies/tuning_registered.json) to this repository
before the first run. So nobody could choose a hypothesis to suit the data. No registry outside this repository has
them, and a pilot with other settings and other robots had already looked at most of them; [below](#what-is-not-shown)
is more on both.

| word | what it means |
|---|---|
| setting | values of α, γ, λ and T |
| score | 0 for random actions, 1 for the best setting of any method, in each task |
| tuned | the best of {n_settings} settings, chosen by some robots and judged by others |
| regret | the score that a setting loses to the one tuned for the task |

## Seven hypotheses

{of_hypotheses}

*Scores, but for H5 and H7, which are in reward a step, and H6, a difference of correlations. In brackets: 95 %
intervals, not corrected. p is corrected for seven tests (Holm). SR is TOSL+SR, QBIASSR is TOSL+QBIASSR.*

## Which settings are good?

{tuning_maps}

## What does tuning cost?

{tuning_price}

{of_methods}

*Mean score of the six tasks.* The paper's setting scores more than {beaten} % of the {n_settings} settings of
TOSL+QBIASSR. *Tuned on the other five* is what the paper's reader would do in a new task: nothing. The settings that
are best on all six:

{of_settings}

## What does the paper's setting lose?

{tuning_regret}

{of_tasks}

## Friction

{tuning_friction}

On ideal robots traces alone gain {traces_ideal} a step.

## How it was done

`make atlas` runs all of it and writes this page; stopped, it goes on where it was. All {runs} final rewards are in
[one file](../../studies/how_much_tuning.npz).

1. **Sweep.** {n_settings} settings fill a box evenly (α 0.02 to 1 and T 0.01 to 10, both in their logarithms; γ 0.5 to
   0.99; λ 0 to 0.98). {n_robots} robots learn at each. They are the same for all settings and methods, that is, they
   have the same random numbers.
2. **Choice.** {n_choosing_robots} new robots choose among the best {n_candidates} settings. The best mean in the sweep
   is partly luck: it is {luck} above what the chosen setting scores in the end.
3. **Judged** by new robots again: 40 in each wandering task but wander_simple, 120 elsewhere.

The six tasks are the paper's, without a physics engine, and as long as in [the report](../reproduction/README.md) or
longer: 3600 steps where a robot wanders, three episodes of navigation, thirty of an arm. *New ground* is `wander_4k`
where no circle pays, as in [a better bias](a_better_bias.md). *Friction and lag* are those of `Realism.vrep()` on
pymunk; there {n_friction_settings} settings were tried by {n_friction_robots} robots. H7's worlds took no part in the
tuning: ten random mazes, the manipulator, and both arms on PyBullet, whose tasks were tuned without it.

## What is not shown

- Tasks in general: these are six, of three kinds. The intervals are over robots and settings, not over tasks.
- A share of good settings depends on the box, and the box is ours.
- The winner is the best of {n_settings}. A finer search would find a better one, for every method.
- Regret is larger where more can be reached. The bias raises what a tuned robot reaches, so its regret may rise while
  its score does not fall.
- H2 to H6 repeat a pilot in the same tasks with new settings and robots: they confirm, and discover nothing. H1 and H7
  are new.
- The sizes were cut once, after the first runs and before any score was looked at, since they took too long. The
  history of [the registration](../../studies/tuning_registered.json) has both.
- Where a hypothesis is not shown, the opposite is not shown either.
- No robot here is real, and only the worlds of H5 have friction.
"""
