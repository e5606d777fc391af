"""The typical wrong answers to the exercises of assignment 3, each an edit of the right one."""

from rlrobot_edu.course.grading.mistake import Mistake

END = "this looks past the end: what stands in the table for the dock is no value. After the last step nothing follows."
KIND = "the two kinds are the wrong way round: accumulating adds 1 at a visit, replacing sets the trace to 1."
VISIT = 'e[s] = e[s] + 1 if kind == "accumulating" else 1'
V_NEXT = "v[s_next] if t + 1 < len(rewards) else 0"

N_STEP = [
    Mistake("the episode has an end: beyond it there are no rewards, and no value is counted. Stop there.",
            {"if t + n < len(rewards):": "if True:",
             "values[t + n]": "values[min(t + n, len(rewards))]"}),
    Mistake("the value at step t + n is missing: what comes after the n rewards counts as the table says.",
            {"if t + n < len(rewards):": "if False:"}),
    Mistake("where the n steps reach the end exactly, nothing follows any more: no value there.",
            {"if t + n < len(rewards):": "if t + n <= len(rewards):"}),
    Mistake("the value lies n steps ahead: it counts γ to the power of n times.", {"gamma**n": "gamma"}),
    Mistake("the value lies n steps ahead: it counts γ to the power of n times, where yours counts in full.",
            {"gamma**n * ": ""}),
    Mistake("the rewards are not discounted: the k-th after t counts γ to the power of k times.",
            {"gamma ** (k - t) * ": ""}),
    Mistake("the first reward counts in full: count the power from t on, not from the start of the episode.",
            {"(k - t)": "k"}),
    Mistake("the first reward counts in full: its power of γ is 0.", {"(k - t)": "(k - t + 1)"}),
    Mistake("the value is that of the state after n steps, values[t + n].", {"values[t + n]": "values[t + n - 1]"}),
    Mistake("the value is that of the state after n steps, values[t + n]. Yours is where it began.",
            {"values[t + n]": "values[t]"}),
    Mistake("n rewards count, and yours are one more.", {"range(t, last)": "range(t, min(last + 1, len(rewards)))"}),
    Mistake("rewards of before t do not count any more.", {"range(t, last)": "range(last)", "(k - t)": "abs(k - t)"}),
]  # fmt: skip

TRACE = [
    Mistake(KIND, {'kind == "accumulating"': 'kind != "accumulating"'}),
    Mistake("both kinds accumulate here: a replacing trace is set to 1, however large it was.",
            {VISIT: "e[s] = e[s] + 1"}),
    Mistake("both kinds replace here: an accumulating trace grows by 1 at each visit.", {VISIT: "e[s] = 1"}),
    Mistake("this fades after the last visit, too. All traces fade first, and then the visited one grows.",
            {"        e *= decay\n": "", VISIT: VISIT + "\n        e *= decay"}),
    Mistake("only the visited trace fades. In each step all of them do.", {"e *= decay": "e[s] *= decay"}),
    Mistake("nothing fades: in each step all traces are multiplied by decay.", {"        e *= decay\n": ""}),
    Mistake("the visits are counted. A trace also fades with each step since.",
            {"        e *= decay\n": "", VISIT: "e[s] = e[s] + 1"}),
    Mistake("the last state of the path is visited, too.", {"for s in path": "for s in path[:-1]"}),
]  # fmt: skip

EPISODE = [
    Mistake(END, {V_NEXT: "v[s_next]"}),
    Mistake(KIND, {'kind == "accumulating"': 'kind != "accumulating"'}),
    Mistake("both kinds accumulate here: a replacing trace is set to 1, however large it was.",
            {VISIT: "e[s] = e[s] + 1"}),
    Mistake("both kinds replace here: an accumulating trace grows by 1 at each visit.", {VISIT: "e[s] = 1"}),
    Mistake("traces fade by γ · λ.", {"gamma * lam": "lam"}),
    Mistake("the traces do not fade: in each step they are multiplied by γ · λ.", {"        e *= gamma * lam\n": ""}),
    Mistake("only the state of this step learns. With traces all of them do, each times its trace: v += α δ e.",
            {"v += alpha * delta * e": "v[s] += alpha * delta"}),
    Mistake("γ is missing in δ: what comes a step later counts γ times.", {"gamma * v_next": "v_next"}),
    Mistake("the traces fade between visit and update, so the state itself learns too little.",
            {"        e *= gamma * lam\n": "", VISIT: VISIT + "\n        e *= gamma * lam"}),
    Mistake("δ is the target minus the old value of s.", {" - v[s]": ""}),
    Mistake("α is missing in the update.", {"alpha * delta": "delta"}),
    Mistake("the reward of each step counts, not only that of the last.",
            {"rewards[t] + gamma": "(rewards[t] if t + 1 == len(rewards) else 0) + gamma"}),
]  # fmt: skip

TRUE_ONLINE = [
    Mistake(END, {V_NEXT: "v[s_next]"}),
    Mistake("this is an accumulating trace. The dutch one keeps the share 1 − α of what is left, and adds 1.",
            {"(1 - alpha) * e[s] + 1": "e[s] + 1"}),
    Mistake("this is a replacing trace. The dutch one keeps the share 1 − α of what is left, and adds 1.",
            {"(1 - alpha) * e[s] + 1": "1"}),
    Mistake("the second line is missing: v[s] −= α (V − V_old).",
            {"        v[s] -= alpha * (v_s - v_old)\n": ""}),
    Mistake("in the first line stands δ + V − V_old, not δ alone.", {"delta + v_s - v_old": "delta"}),
    Mistake("V is what s was worth before the update. Keep it in a variable of its own.",
            {"v[s] -= alpha * (v_s - v_old)": "v[s] -= alpha * (v[s] - v_old)"}),
    Mistake("V_old for the next step is V' as it was before the update of this step.",
            {"v_old = v_next\n": "v_old = v[s_next]\n"}),
    Mistake("V_old must be handed on: at the end of each step it becomes V'.", {"v_old = v_next\n": "v_old = 0\n"}),
    Mistake("V_old becomes V', the value of the next state, not V.", {"v_old = v_next\n": "v_old = v_s\n"}),
    Mistake("traces fade by γ · λ.", {"gamma * lam": "lam"}),
    Mistake("only the visited state changes in the first line. All do, each times its trace: v += α (…) e.",
            {"v += alpha * (delta + v_s - v_old) * e": "v[s] += alpha * (delta + v_s - v_old) * e[s]"}),
    Mistake("the second line is of the visited state alone: v[s], not v.", {"v[s] -= alpha": "v -= alpha"}),
]  # fmt: skip

WATKINS = [
    Mistake("this looks past the end. After a terminated step nothing follows, so the target is the reward alone.",
            {"best = 0 if terminated else max(q[s_next])": "best = max(q[s_next])"}),
    Mistake("the traces are never cut. Where a' is not a best action, they become 0.",
            {" if greedy else 0": " if not terminated else 0"}),
    Mistake("the cut is the wrong way round: the traces live on where a' is a best action.",
            {"if greedy": "if not greedy"}),
    Mistake("after a terminated step all traces are 0: the next episode has nothing to do with this one.",
            {"greedy = not terminated and q[s_next, a_next] == best":
             "greedy = terminated or q[s_next, a_next] == best"}),
    Mistake("whether a' is a best action, the table tells as it was before the update. Ask first, then change it.",
            {"    greedy = not terminated and q[s_next, a_next] == best\n": "",
             "    e *= gamma": "    greedy = not terminated and q[s_next, a_next] == max(q[s_next])\n    e *= gamma"}),
    Mistake("of several best actions argmax knows the first alone. a' is a best one if its value is the largest.",
            {"q[s_next, a_next] == best": "a_next == q[s_next].argmax()"}),
    Mistake("this is SARSA's target. Watkins keeps Q-learning's: the best action of s'.",
            {"gamma * best": "gamma * (0 if terminated else q[s_next, a_next])"}),
    Mistake("the traces are cut before this step has taught anything. First the update, then the cut.",
            {"e[s, a] = 1\n": "e *= 1 if greedy else 0\n    e[s, a] = 1\n"}),
    Mistake("the visited pair is cut as well before it learns: set its trace to 1, update, and cut then.",
            {"    q += alpha * delta * e\n    e *= gamma * lam if greedy else 0":
             "    e *= gamma * lam if greedy else 0\n    q += alpha * delta * e"}),
    Mistake("this is an accumulating trace. Here it is replaced: the visited pair's is set to 1.",
            {"e[s, a] = 1": "e[s, a] += 1"}),
    Mistake("traces fade by γ · λ.", {"e *= gamma * lam": "e *= lam"}),
    Mistake("where the traces live on, they still fade, by γ · λ.", {"gamma * lam if greedy": "1 if greedy"}),
    Mistake("only (s, a) learns. With traces all pairs do, each times its trace: q += α δ e.",
            {"q += alpha * delta * e": "q[s, a] += alpha * delta"}),
]  # fmt: skip
