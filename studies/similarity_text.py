"""The text of docs/when_similarity_helps.md. Verdicts were written after looking at the numbers; tables are
computed."""

PAGE = r"""# When does similarity help?

QBIASSR adds to $Q(s)$ a bias, the advice of [similar states](../notebooks/05_qbiassr.ipynb). This page says what the
bias is, whatever was learned, and what follows for a robot. `python studies/similarity.py` measures everything here in
some ten minutes and writes this page from its [numbers](../studies/similarity.json); people wrote the verdicts.

## The theorem

A task has $n$ inputs. Split the values of an action into parts: $Q = \sum_U Q_U$, with one part for each set $U$ of
inputs. $Q_\emptyset$ is the mean over all states. $Q_{{\{{i\}}}}$ is what input $i$ alone adds to it, and each further
$Q_U$ is what only these inputs together can tell. This is a functional analysis of variance. Then

$$Q + bias = \sum_U \left(2 - \frac{{|U|}}{{n}}\right) Q_U$$

**What needs no input is doubled. What needs $k$ inputs at once, a part of order $k$, is multiplied by $2 - k/n$. What
needs all inputs at once is left alone.**

![{factors_alt}](pictures/similarity_factors.png)

*Proof.* Let $M_i$ be the mean over all bins of input $i$.

1. $M_i M_i = M_i$ and $M_i M_j = M_j M_i$. Put $Q_U = \prod_{{i \in U}} (1 - M_i) \prod_{{i \notin U}} M_i \, Q$.
2. These parts sum to $Q$, since the product of all $(1 - M_i) + M_i = 1$, multiplied out, has one term for each $U$.
3. If $i \in U$, then $M_i Q_U = 0$, since $M_i (1 - M_i) = 0$. If $i \notin U$, then $M_i Q_U = Q_U$.
4. $bias = \frac{{1}}{{n}} \sum_i M_i Q$. So each $Q_U$ comes back from the $n - |U|$ inputs outside $U$:
   $bias = \sum_U \left(1 - \frac{{|U|}}{{n}}\right) Q_U$. $\square$

It needs what [qbiassr.py](../rlrobot_edu/learning/selections/qbiassr.py) does:

- *The state is in each of its own sets.* Without it, two bins would have −1 in place of 0 in line 3.
- *All bins of an input count alike*, and each input counts $1/n$. Visits do not matter: a state that was never seen, or
  cannot occur, counts with its $Q$ of 0. The bias [weighed by visits](studies/a_better_bias.md) is another one.
- *Inputs may have different numbers of bins.* One with a single bin is in no part, and still counts in $n$.
- *Actions do not mix.* How $Q$ was learned does not matter, nor do normalisation and loop evasion.

`pytest tests/library/test_what_the_bias_is.py` compares the library's bias with another split, to $10^{{-12}}$, for
random shapes. Three other biases fail there.

## What follows

**The bias is a low-pass filter, with the blind robot at its end.** The bias of the bias, again and again, tends to
$Q_\emptyset$. That is one preference for all states, as of [a robot that sees nothing](studies/blind.md).

**Part of it is temperature.** If a table has order $k$ alone, QBIASSR at $T$ chooses exactly as SR at $T / (2 - k/n)$,
which is between $T/2$ and $T$. That is a fair SR to compare with. For any table, the SR whose preferences are nearest
to QBIASSR's (least squares) is at $T$ divided by the mean of $2 - k/n$, weighed by how much of the variance of $Q$ each
order has. For random numbers this mean is $1 + c$ of the [notation](notation.md).

## Of what order is a robot's Q?

![{spectra_alt}](pictures/similarity_spectra.png)

Shares are of the variance of $Q$ over all states, less the mean of the actions, which changes no choice. Robots are
moved by geometry alone. In `wander_simple`, with two inputs, order 2 has only {simple_full:.0f} %, so the bias
enlarges nearly all that the robot knows: the mean factor is {simple_factor:.2f}. In `wander_1k` orders 0 to 2 have
{wander_low:.0f} %, where a table of random numbers has {wander_noise:.0f} %; the mean factor is {wander_factor:.2f},
of random numbers {wander_noise_factor:.2f}. In `arm_1k` both are nearly the same: {arm_low:.0f} and {arm_noise:.0f} %,
{arm_factor:.2f} and {arm_noise_factor:.2f}. A table in which few states were visited looks like random numbers, so this
is about the table, and not about the task alone.

## Does the gain fall with the order?

{worlds} random worlds of each order have the size of `wander_1k`: $4^5$ states, drawn evenly, and 9 actions. Rewards
are random, of order $k$ alone, with a standard deviation of 2. Q-learning has γ = 0 and α = 0.3, no loop evasion, and
$Q$ itself as preference. What QBIASSR earns a step more than SR at the same $T$ (± half of the 95 % interval, Student's
t over the worlds):

{gain_over_sr}

And more than SR at $T / (2 - k/n)$:

{gain_over_fair}

![{gain_alt}](pictures/similarity_gain.png)

- **The gain falls with the order**, at both temperatures: by {slope_1} at T = 1 and {slope_02} at T = 0.2 for each
  order, in the first 20,000 steps.
- **At T = 1 it is temperature first.** After 3,600 steps no order gains over SR at the fair temperature, and orders 0
  to 1 lose a little. Later the low orders gain: {fair_1_0_20000} for order 0 after 20,000 steps, {fair_1_1_20000} for
  order 1.
- **At T = 0.2 it is advice.** A colder SR is no better, and over the fair one QBIASSR gains {fair_02_0_3600} at order 0
  in 3,600 steps. At order 5 it loses {sr_02_5_3600}. The theorem leaves a pure order 5 alone, but a table with few
  visits is not pure: it has low orders that the rewards do not have.

## What we could not show

Does good advice explain where QBIASSR gains? *Advice skill*: take the table of a robot that acts at random for a
million steps ({long_worked:,} in `worked_example`), and the states in which it tried every action {tried} times or
more. In each, the other states' advice is the bias without the state itself; its favourite loses
$\max Q(s) - Q(s, a)$. The skill is 1 minus the sum of these losses over the sum for a random action: 1 if the advice is
always right, 0 if it is as good as chance. *Gain*: final average reward of Q+QBIASSR less Q+SR at the default
parameters, {robots} robots each.

{advice}

**It does not.** Spearman's rank correlation is {rho:+.2f} (p = {rho_p:.2f}, n = 8). Eight tasks would show only one of
{critical:.2f} or more. The table of a million random steps is not the table of a robot in its first hour, so visits
will have to enter; we have not found how.

## Limits

The worlds have no robot: states come evenly, rewards at once. They show what the theorem does when nothing else acts,
at two temperatures that we chose. The spectra are of one method and three tasks on ideal robots. Nothing here was
registered before it was run, and the intervals are not corrected.
"""
