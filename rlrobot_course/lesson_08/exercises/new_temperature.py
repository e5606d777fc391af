"""The temperature of loop evasion after a step."""

from __future__ import annotations

import numpy as np

from rlrobot_course.grading.answers import read_answers
from rlrobot_course.grading.exercise import Exercise
from rlrobot_course.grading.mistake import Mistake
from rlrobot_course.grading.replay import Case
from rlrobot_course.lesson_08.exercises.redundancy import redundancy


def new_temperature(temperature, states, rewards, s, default):
    visited_before = states.count(s) > 1
    low = sum(rewards) / len(rewards) < 0
    if visited_before and low and redundancy(states) > 2:
        return min(50, temperature + 0.25 * redundancy(states))
    return default


IDLE = [-0.02] * 8

HITS = [-0.02, -2.0, -0.02, -2.0, -0.02, -0.02, -0.02, -0.02]

# (temperature, states, rewards, default); s is the last of the states
SITUATIONS = (
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], HITS, 0.5),  # a loop; from here on all classic mistakes differ
    (1.0, [0, 1, 2, 3, 4, 5, 6, 7], [10.0] * 8, 1.0),  # on its way
    (1.0, [4, 6, 4, 6, 4, 6, 4, 6], IDLE, 1.0),
    (2.0, [4, 6, 9, 4, 6, 9, 4], IDLE[:7], 1.0),  # three states, and a redundancy of little more than 2
    (5.0, [0, 1, 2, 3, 4, 5, 6, 0], IDLE, 1.0),  # once round a large circle
    (5.0, [6, 4, 6, 4, 6, 1, 2, 1], IDLE, 1.0),  # redundancy of exactly 2
    (2.0, [4, 4, 4, 6, 6, 6, 9, 9], IDLE, 0.5),  # s twice in it, and a redundancy that is no whole number
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [10.0, -2.0, -2.0, 10.0, -2.0, 10.0, -2.0, -2.0], 1.0),  # a loop that pays
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [-2.0] * 7 + [10.0], 1.0),  # a loop that does not, though the last one is positive
    (3.0, [3, 3, 3, 5, 5, 5, 3, 9], IDLE, 1.0),  # it has just left
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [10.0] + [-2.0] * 7, 1.0),  # a loop that pays no more
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [15.0] + [-2.0] * 7, 1.0),  # it pays by its first step
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [-1.0] * 7 + [10.0], 1.0),  # it pays by its last one
    (2.0, [1, 0, 1, 0, 1, 0, 1, 0], IDLE, 1.0),  # states of small numbers
    (3.0, [4, 6, 4, 6, 4, 6, 4, 6], [-0.001] * 8, 1.0),  # it costs hardly anything
    (2.0, [*range(30), *range(30), 0], [-0.02] * 61, 1.0),  # a longer queue, and a redundancy of hardly more than 2
    (7.0, [3, 5, 3, 5, 3, 5, 3, 5], [0.0] * 8, 1.0),  # zero is not negative
    (9.0, [0, 1, 2, 3, 4, 5, 6, 7], IDLE, 0.1),  # another default
    (0.1, [3, 3, 3, 3, 3, 3], IDLE[:6], 0.1),  # a shorter queue
    (0.37, [7, 8] * 10 + [7], [-0.02] * 21, 0.37),  # a longer one
    (49.5, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),  # near the cap
    (50.0, [3, 3, 3, 3, 3, 3, 3, 3], IDLE, 0.1),
)


def another_situation(rng: np.random.Generator, case: Case) -> Case:
    """The same signs in other states, with other temperatures and sizes of rewards. Who is near the cap stays there."""
    heat, size, shift = *rng.uniform(0.5, 2.0, size=2).tolist(), int(rng.integers(1, 50))
    states = [s + shift for s in case["states"]]
    return {
        "temperature": case["temperature"] * (heat if case["temperature"] < 40 else 1.0),
        "states": states,
        "rewards": [r * size for r in case["rewards"]],
        "s": states[-1],
        "default": case["default"] * heat,
    }


RISE = "min(50, temperature + 0.25 * redundancy(states))"

WITNESSES = read_answers(__file__, {})[1]

exercise = Exercise(
    task="return the temperature that LRLE sets",
    right=new_temperature,
    returns="temperature",
    lenders={name: "the function of the exercise above: write it, and run its cell" for name in ("redundancy", "push")},
    tape=[
        {"temperature": temperature, "states": states, "rewards": rewards, "s": states[-1], "default": default}
        for temperature, states, rewards, default in SITUATIONS
    ],
    another=another_situation,
    mistakes={
        "stays_hot": Mistake("outside a loop the temperature falls back to the default; here it stays as it is.",
            {"return default": "return temperature"}),
        "own_default": Mistake("the temperature outside loops is the argument default, not always 1.",
            {"return default": "return 1.0"}),
        "never_heats": Mistake("the temperature never rises here. Is the redundancy upside down (it is size / "
            "different)? Or did you take the sizes of the rewards, without their signs, or the mean of the states?",
            {"if visited_before": "if False"}),
        "or_for_and": Mistake("all three signs must be there at once: and, where you have or.", {" and ": " or "}),
        "no_cap": Mistake("the temperature has a cap: it never rises above 50.", {RISE: RISE[8:-1]}),
        "larger_of_both": Mistake("max(50, …) is at least 50. The temperature may be at most 50: min.",
            {"min(50": "max(50"}),
        "falls_at_the_cap": Mistake("at the cap the temperature stays at 50 while the loop lasts.",
            {"redundancy(states) > 2": "redundancy(states) > 2 and temperature < 50"}),
        "jumps": Mistake("the temperature does not jump to 50 at once: it rises by a quarter of the redundancy.",
            {RISE: "50"}),
        "cap_before_the_step": Mistake("from 49.5, this steps over 50. It is the new temperature that may be at most "
            "50.", {RISE: "temperature + (0.25 * redundancy(states) if temperature < 50 else 0)"}),
        "inverted": Mistake("it heats where there is no loop, and not where there is one: the if is turned round.",
            {"if visited_before and low and redundancy(states) > 2:":
                "if not (visited_before and low and redundancy(states) > 2):"}),
        "always_heats": Mistake("it heats always, whatever the signs say.", {"return default": f"return {RISE}"}),
        "own_length": Mistake("the queues that come in here are full, and not always 21 long.",
            {"if visited_before": "if len(states) == 21 and visited_before"}),
        "redundancy_of_2": Mistake("a redundancy of exactly 2 is not enough: it must be above 2, so > and not ≥.",
            {"> 2": ">= 2"}),
        "no_redundancy": Mistake("the third sign is missing: act only if the redundancy is above 2.",
            {" and redundancy(states) > 2": ""}),
        "number_of_states": Mistake("the third sign is the redundancy, size / different, above 2, not the number of "
            "different states.", {"redundancy(states) > 2": "len(set(states)) > 2"}),
        "loops_that_pay_too": Mistake("the second sign is missing. This loop pays: its mean reward is not below 0. "
            "Such a loop is left in peace.", {" and low": ""}),
        "pays_inverted": Mistake("it is the other way round: the mean reward must be below 0.", {"< 0": "> 0"}),
        "mean_of_0": Mistake("a mean reward of exactly 0 is not below 0: < and not ≤.", {"< 0": "<= 0"}),
        "much_below_0": Mistake("below 0 is enough, however little.", {"< 0": "< -0.1"}),
        "as_low_as_idling": Mistake("any mean below 0 counts, however little it is below: not only −0.02, which is "
            "what idling costs in one task.", {"< 0": "< -0.01"}),
        "first_reward": Mistake("you look at the oldest reward only. It is the mean over the queue that must be below "
            "0.",
            {"sum(rewards) / len(rewards)": "rewards[0]"}),
        "not_the_newest_reward": Mistake("the newest reward counts in the mean, too: take all of rewards.",
            {"sum(rewards) / len(rewards)": "sum(rewards[:-1])"}),
        "not_the_oldest_reward": Mistake("the oldest reward counts in the mean, too: take all of rewards.",
            {"sum(rewards) / len(rewards)": "sum(rewards[1:])"}),
        "redundancy_of_2_1": Mistake("a redundancy above 2 is enough, however little above: > 2.", {"> 2": "> 2.1"}),
        "brackets_of_the_sum": Mistake("brackets: 0.25 is multiplied by the redundancy, and then added to the "
            "temperature.", {"temperature + 0.25 * redundancy(states)": "(temperature + 0.25) * redundancy(states)"}),
        "last_reward": Mistake("you look at the last reward only. It is the mean over the queue that must be below 0.",
            {"sum(rewards) / len(rewards)": "rewards[-1]"}),
        "worst_reward": Mistake("one bad reward is not enough: it is the mean over the queue that must be below 0.",
            {"sum(rewards) / len(rewards)": "min(rewards)"}),
        "best_reward": Mistake("not every reward must be below 0, only their mean.",
            {"sum(rewards) / len(rewards)": "max(rewards)"}),
        "s_itself_counts": Mistake("the first sign is missing, or always true. s has just been pushed, so it is in "
            "the queue; it was there before if it is in it more than once.", {"> 1": "> 0"}),
        "three_times": Mistake("twice is enough: s has just been pushed, and it was there once before.",
            {"> 1": "> 2"}),
        "standing_still": Mistake("you ask whether the robot stands still, s twice in a row. Any earlier place in the "
            "queue counts.", {"states.count(s) > 1": "states[-2] == s"}),
        "oldest_alone": Mistake("you ask whether s is the oldest in the queue. Any earlier place in it counts.",
            {"states.count(s) > 1": "states[0] == s"}),
        "from_the_default": Mistake("the temperature rises from where it is, not from the default. So it climbs while "
            "the loop lasts.", {"temperature + ": "default + "}),
        "quarter_alone": Mistake("a quarter of the redundancy is added, not a quarter alone.",
            {"0.25 * redundancy(states)": "0.25"}),
        "no_quarter": Mistake("a quarter of the redundancy is added: the factor 0.25 is missing.", {"0.25 * ": ""}),
        "multiplies": Mistake("the rise is added to the temperature, not multiplied with it.",
            {"temperature + ": "temperature * "}),
        "rise_alone": Mistake("the rise alone is not the temperature: add it to the one up to now.",
            {"temperature + ": ""}),
        "falls": Mistake("the temperature falls here. In a loop it should rise.", {"temperature + ": "temperature - "}),
        "divides": Mistake("0.25 times the redundancy, not 0.25 divided by it: the tighter the loop, the more heat.",
            {"0.25 * redundancy(states)": "0.25 / redundancy(states)"}),
        "own_redundancy": Mistake("the redundancy is not always 10.5: work it out from states.",
            {"redundancy(states)": "10.5"}),
        "visits_of_s": Mistake("it is the redundancy that counts, not how often s alone is in the queue.",
            {"0.25 * redundancy(states)": "0.25 * states.count(s)"}),
        "adds_quarter": Mistake("0.25 times the redundancy, not 0.25 plus it.",
            {"0.25 * redundancy(states)": "0.25 + redundancy(states)"}),
        "not_the_last_state": Mistake("s has been pushed already and counts in the redundancy like the others: take "
            "all of states.", {"redundancy(states)": "redundancy(states[:-1])"}),
        "whole_division": Mistake("// cuts off what comes after the point. The redundancy is size / different.",
            {"redundancy(states)": "(len(states) // len(set(states)))"}),
        "length_of_21": Mistake("a queue is not always 21 long: take len(states).",
            {"redundancy(states)": "(21 / len(set(states)))"}),
        "falls_slowly": Mistake("outside a loop the temperature falls to the default at once, not little by little.",
            {"return default": "return max(default, temperature - 0.25 * redundancy(states))"}),
        "falls_by_a_quarter": Mistake("outside a loop the temperature falls to the default at once, not little by "
            "little.", {"return default": "return max(default, temperature - 0.25)"}),
        "pushes_s_again": Mistake("s has been pushed already. Here it is counted, and the queue changed, once more.",
            {"visited_before = states.count(s) > 1": "states.append(s); visited_before = states.count(s) > 2"}),
        "cap_of_21": Mistake("the cap is 50. (21 is the size of the queue.)", {"min(50": "min(21"}),
        "int": Mistake("a temperature need not be whole. int(…) cuts off what comes after the point.",
            {RISE: f"int({RISE})"}),
        "quarter_cut_off": Mistake("// cuts off what comes after the point: write 0.25 * or / 4.",
            {"0.25 * redundancy(states)": "redundancy(states) // 4"}),
        "quarter_of_the_sum": Mistake("brackets: a quarter of the redundancy is added, not a quarter of the sum.",
            {"temperature + 0.25 * redundancy(states)": "0.25 * (temperature + redundancy(states))"}),
        "default_at_the_cap": Mistake("at the cap the temperature stays at 50 while the loop lasts. Here it falls "
            "back to the default.", {f"return {RISE}": f"return {RISE[8:-1]} if {RISE[8:-1]} <= 50 else default"}),
        "adds_default": Mistake("it is the temperature that rises; the default is not added to it.",
            {"temperature + ": "default + temperature + "}),
        "falls_to_0": Mistake("outside a loop the temperature is the default, not 0.", {"return default": "return 0"}),
    },
    hints=(
        "Give each of the three signs a line of its own, with a name: it is True or False. Then one if.",
        "states.count(s) > 1 is the first sign; the mean of rewards below 0 the second; your redundancy above 2 the "
        "third.",
        "if first and second and third: return min(50, temperature + 0.25 * …), and after it: return default.",
    ),
    gained="This is the whole of LRLE, and it will free a robot in a minute. In lesson 09 it joins your learner.",
    witnesses=WITNESSES,
)  # fmt: skip
