"""The text of docs/when_similarity_helps.md. Verdicts were written after looking at the numbers; tables are
computed."""

PAGE = r"""# When does similarity help?

For those who have read [lesson 05](../notebooks/05_qbiassr.ipynb) and like a proof. QBIASSR adds to $Q(s)$ a bias, the
advice of similar states. Here is what this bias is, whatever was learned, and what follows from it.
`python studies/similarity.py` measures all that was measured, in some ten minutes, and writes this page from its
[numbers](../studies/similarity.json); people wrote the verdicts.

## The theorem

A task has $n$ inputs. Split the values of an action into parts, $Q = \sum_U Q_U$, one for each set $U$ of inputs:
$Q_\emptyset$ is the mean over all states, $Q_{{\{{i\}}}}$ is what input $i$ alone adds to it, and each further $Q_U$ is
what only these inputs together can tell. This is a functional analysis of variance. Then

$$Q + bias = \sum_U \left(2 - \frac{{|U|}}{{n}}\right) Q_U$$

**What needs no input is doubled. A part of order $k$, which needs $k$ inputs at once, is multiplied by $2 - k/n$. What
needs all inputs at once is left alone.**

![{factors_alt}](pictures/similarity_factors.png)

*Proof.* Let $M_i$ be the mean over all bins of input $i$.

1. $M_i M_i = M_i$ and $M_i M_j = M_j M_i$. Let $Q_U = \prod_{{i \in U}} (1 - M_i) \prod_{{i \notin U}} M_i \, Q$.
2. These parts sum to $Q$: multiply out the product of all $(1 - M_i) + M_i = 1$.
3. $M_i Q_U = 0$ if $i \in U$, since $M_i (1 - M_i) = 0$; otherwise $M_i Q_U = Q_U$.
4. $n - |U|$ inputs are outside $U$, so
   $bias = \frac{{1}}{{n}} \sum_i M_i Q = \sum_U \frac{{n - |U|}}{{n}} Q_U$. $\square$

It holds for what [qbiassr.py](../rlrobot_edu/learning/selections/qbiassr.py) computes:

- *The state is in each of its own sets.* Without it, two bins would have −1 in place of 0 in line 3.
- *All bins count alike.* So a state that was never visited, or cannot occur, counts with its $Q$ of 0. The bias
  [weighed by visits](studies/a_better_bias.md) is another one.
- *Inputs count alike*, with any numbers of bins. One with a single bin is in no part, but counts in $n$.
- *Actions do not mix.* How $Q$ was learned does not matter. Normalisation and loop evasion come after the bias.

`pytest tests/library/test_what_the_bias_is.py` compares the library's bias with another way to split, to $10^{{-12}}$,
for random shapes; three other biases fail.

## What follows

**The bias is a low-pass filter, with the blind robot at its end.** The bias of the bias, again and again, tends to
$Q_\emptyset$: one preference for all states, like that of [a robot that sees nothing](studies/blind.md).

**Part of it is temperature.** If a table has order $k$ alone, QBIASSR at $T$ chooses exactly as SR at $T / (2 - k/n)$.
That is the fair SR to compare with, between $T/2$ and $T$. For any table, the SR with the nearest preferences (least
squares) is at $T$ divided by the *mean factor*: the mean of $2 - k/n$, weighed by the share of each order in the
variance of $Q$. For random numbers it is $1 + c$ of the [notation](notation.md), on average.

## Of what order is a robot's Q?

![{spectra_alt}](pictures/similarity_spectra.png)

The variance is over all states, after each state's mean over the actions, which changes no choice, was subtracted.
Robots are moved by geometry alone.

{spectra}

In `wander_1k` the low orders have far more than random numbers would give them, in `arm_1k` little more. Few visited
states among many zeros also look random, so this describes the table, not the task alone.

## Does the gain fall with the order?

There are {worlds} random worlds of each order, of the size of `wander_1k`: $4^5$ states, drawn evenly, and 9 actions.
Rewards have order $k$ alone and a standard deviation of 2. Q-learning has γ = 0 and α = 0.3, no loop evasion, and the
preferences are $Q$ itself. What QBIASSR earns a step more than SR at the same $T$, ± half of the 95 % interval
(Student's t over the worlds):

{gain_over_sr}

And more than SR at $T / (2 - k/n)$:

{gain_over_fair}

![{gain_alt}](pictures/similarity_gain.png)

- **The gain falls with the order**, by {slope_1} an order at T = 1 and {slope_02} at T = 0.2 (20,000 steps).
- **At T = 1 most of it is temperature.** In orders 0 to 4 QBIASSR is not ahead of the fair SR after 3,600 steps. At
  both later lengths it is, in orders 0 to 2 alone.
- **At T = 0.2 most of it is advice.** In orders 0 to 3 QBIASSR is ahead of the fair SR, too.
- **At T = 0.2 advice hurts in orders 4 and 5**: after 20,000 steps QBIASSR is behind both. The theorem leaves order 5
  alone. But a table in which much was never tried has low orders that these rewards do not have.

## What does the bias say in a new state?

A hundred robots (`TOSL+QBIASSR`, ideal walls, seeds {first_seed} to {last_seed}) lived their first hour of `wander_1k`.
Whenever one stood in a state for the first time, all nine actions were tried from that very place. *By lot* all are
equally likely; *asked*, they have the robot's own probabilities, which there are the bias alone. A step *pays* if its
reward is above 1. In brackets the rise in points, paired by robot, ± half of the 95 % interval, where that excludes 0:

{asked}

**{memories}** The more of its 15 similar
states a robot knows, the more often its next step pays. Asking does not make a bump rarer.
`python studies/stage_numbers.py` writes this table, and the sentence on [the stage](stage.md), from its
numbers, `rlrobot_edu/widgets/stage/numbers.json`; seeds and measures were
[registered](../studies/stage_registered.json) before it was run.

## What we could not show

Does good advice explain where QBIASSR gains? *Advice skill*: a robot acts at random for a million steps
({long_worked:,} in `worked_example`), {teachers} robots a task. In each state in which it tried every action {tried}
times or more, the advice is the bias without the state itself, and its favourite $a$ loses $\max Q(s) - Q(s, a)$. The
skill is 1 minus the sum of these losses over that of random actions: 1 if the advice is always best, 0 if it is no
better than chance. *Gain*: final average reward of Q+QBIASSR less Q+SR after an hour (navigation: 3 episodes, arms: 30)
with default parameters, {robots} robots each.

{advice}

**Advice skill is not shown to predict the gain.** Spearman's rank correlation is {rho:+.2f} (p = {rho_p:.2f}, n = 8);
eight tasks would show only {critical:.2f} or more. In `arm_4k` and `worked_example` the advice is best, and no gain is
shown. The theory does not yet explain the robots. Visits, which are not even, probably have to enter.

## Limits

The worlds of one order have no robot, no next state that depends on an action, and two temperatures that we chose. The
spectra are of one method and ideal robots. Only the study of new states was registered. No interval is corrected.
"""
