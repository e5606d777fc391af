"""The text of docs/bias.md. Its findings were written after looking at the outcomes; tables and counts are computed."""

PAGE = """# Which bias helps, when, and how much?

Tables and figure are written by `python studies/bias_study.py`. QBIASSR, the paper's selection, adds to Q(s) a bias:
the mean Q of similar states. Three of its properties are open to question. States that were never visited contribute
their zeros. The state s is among its own similar states, so that Q(s) counts more than once, which is the same as a
lower temperature. And the bias never ends. Four other selections each change one of these properties. All learn with
TOSL and the paper's defaults.

| name | its bias |
|---|---|
| [QBIASSR](../rlrobot_edu/learning/selections/qbiassr.py) | the paper's |
| [VBIASSR](../rlrobot_course/lesson_22/vbiassr.py) | each state's say weighed by how often it tried the action |
| [OBIASSR](../rlrobot_course/lesson_22/biases.py) | of the other states alone, without s |
| [FBIASSR](../rlrobot_course/lesson_22/biases.py) | times (1 − α)^N: it fades with the visits N(s, a) |
| [TBIASSR](../rlrobot_course/lesson_22/biases.py) | QBIASSR's preferences, divided: Q(s) counts once, as in SR |

They are compared with plain softmax regression at three temperatures: **SR**, T = 1, as all of them; **SR, colder**,
T = 1 / (1 + c), at which SR counts Q(s) as QBIASSR does (c is the mean of 1 / bins over the inputs: 0.25 in
`wander_1k`, so T = 0.8); **SR, half**, T = 1/2, the effective temperature of a biased selection if all similar states
agree with s. If a selection is not better than all three, its success may be due to the temperature.

In the tables of means stand two more, which see little: **blind**, TOSL+SR to which all places are one state, and, in
tasks of lasers with more than two bins, **coarse**, TOSL+SR that sees of each laser whether it is in its lowest bin.
Both are without loop evasion, which looks at states. They came later and are in none of the tests.

## What we found

1. **On the robots that wander with five or six lasers, the bias is real.** In `wander_1k` all five biases beat SR at
   all three temperatures after an hour, in `wander_4k` four of them, in `wander_12k` VBIASSR alone. In `wander_1k` a
   lower temperature gains nothing: SR earns 4.14, 4.06 and 3.87. So there the bias does more than a lower temperature.
2. **Weighing by visits earns most of the biases, but one that sees little often earns as much.** VBIASSR is
   significantly better than the paper's QBIASSR, early and late, in `wander_1k`, `wander_4k` and `wander_12k`, and late
   in `giraff_wander_1k` and `giraff_wander_4k`. In `wander_4k` it earns more in the first five minutes (6.45 a step)
   than any other bias in an hour (4.68 at most; its own is 8.67), and so it does with 12,500 states. But with the 25
   actions of these two tasks a robot can drive in a circle, for 10.00 a step, and [one that sees nothing](blind.md)
   finds that out: it earns 7.94 in `wander_4k`, no less than VBIASSR as far as 30 robots show (p = 0.18). In
   `giraff_wander_4k` the blind robot earns 1.25 and VBIASSR −0.27; in `giraff_wander_1k` no difference is shown (p =
   0.40). So there VBIASSR's gain is no proof that it knows more. Where no circle pays, it is ahead of the blind robot
   and of QBIASSR: in `wander_1k` 6.68 beside QBIASSR's 5.52 and the blind robot's 3.61, in `wander_4k` with nine
   actions 6.58 beside 4.72 and 3.61. But whether a wall is near on which side is enough for 6.33 in `wander_1k`.
3. **Early or late?** In the first five minutes only VBIASSR is better than SR at all three temperatures, in the same
   three tasks. The others need the hour.
4. **In tasks of four states a bias does not help, and it can hurt.** The states have little to share: each needs its
   own action. OBIASSR, in which the other states count as much as s, is far worse in `wander_simple`, on the robot and
   on the model (g about −2.5 and −3). FBIASSR, which fades, is the only one that is nowhere significantly worse than SR
   at T = 1.
5. **With the arms and in `navigation_1k` the temperature may be all.** In `arm_4k`, after ten episodes, SR earns 8.06
   and at T = 1/2 5.72: cold hurts, and VBIASSR's 4.80 is significantly less than SR's at T = 1. On the mobile
   manipulator SR earns −0.10 and at T = 1/2 2.21: cold helps, and VBIASSR's 3.48 is significantly more than SR's at T =
   1. In `navigation_1k` QBIASSR, VBIASSR and FBIASSR beat SR at T = 1 after three episodes, and none beats it at T =
   1/2; after the first, VBIASSR beats both. In none of these tasks is a bias better, or worse, than SR at all three
   temperatures.
6. **On sample models the temperature is enough to explain it.** No bias is anywhere better than SR at all three
   temperatures. What VBIASSR gains on the models of `wander_1k` and `wander_4k`, SR gains at T = 1/2. In these models
   most pairs were never recorded and lead anywhere (`unseen="uniform"`). There, we think, it pays to explore less, and
   similar states have little to tell. Nor does it pay to look: on the models of `wander_1k`, `wander_4k` and
   `wander_12k` the blind agent has a higher mean than each of them (7.14 beside VBIASSR's 6.71 in `wander_1k`). A bias
   should be judged on a robot.
7. **Taking s out of its sets, or correcting the temperature, is no improvement by itself.** TBIASSR is close to QBIASSR
   in most tasks. Its use is to show that the temperature is not the cause.

**Which one we would choose:** for wandering robots with several similar lasers first two bins a laser, and VBIASSR
where more are needed: [a registered study](a_better_bias.md) compares them, and others. The gains with thousands of
states and 25 actions, and Giraff's, are no argument, since a [robot that sees nothing](blind.md) has them, too. SR for
a few states and for an arm at its table; there, first try other temperatures. If one of these selections must do for
all tasks, FBIASSR: it gains less, and nowhere is it shown to be worse than SR at the same T = 1. The paper's QBIASSR
remains the toolkit's default, since the toolkit reproduces the paper.

## What we do not know

{missing}- Why VBIASSR gains so much with lasers and hurts the arm at its table. Neighbouring positions of a gripper may
need different actions, while a near wall means the same to one laser whatever the others see. This is a guess.
- How much of VBIASSR's gain in `wander_4k` and `wander_12k` is driving in circles.
- Answers that came later are in [the registered study](a_better_bias.md): what is left in tasks in which no circle
  pays, QBIASSR at lower temperatures, VBIASSR that fades, other algorithms, parameters and mazes, lag and friction.
- Dunnett's test keeps the chance of a false alarm at 5 % for the comparisons with one control, in one task after one
  length. There are many such families here: a few of the weaker findings (p above 0.01) will be chance. It also assumes
  equal variances, which is not quite true. The findings about VBIASSR in `wander_1k`, `wander_4k` and `wander_12k` have
  p below 10⁻⁶.
- VBIASSR treats values that were put into Q without visits, such as those of another agent, as unknown.

## How often

Number of tasks and lengths in which a selection is significantly better / worse (Dunnett, p < 0.05), on the robots
(30 repetitions each):

{on_robots}

and on sample models of the shipped recordings (100 repetitions each):

{on_models}

## How much

Hedges' g against SR at T = 1 with its 95 % interval, each selection with a marker of its own; the grey bar is SR at
T = 1/2.

{figure}

Mean final average reward, late. ▲: better than SR at each of the three temperatures, ▼: worse than each (p < 0.05).
In tasks with episodes it is that of the last episode. Arms are simulated by geometry alone (`engine="kinematic"`).

{late}

The same, early:

{early}

## All tests

Hedges' g of each biased selection against SR at each temperature, and against QBIASSR; bold with p where Dunnett's test
finds it significant.

{all_tests}
"""
