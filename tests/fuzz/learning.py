"""Programs with agents and environments: the library's own, other people's, wrapped ones; and experiments."""

from __future__ import annotations

from hypothesis import strategies as st

from fuzz.programs import given, program
from fuzz.values import call, some, value

STATE, ACTION = value("0", "1", "23", "np.int64(3)"), value("0", "1", "2")
NUMBER, FLAG = value(), value("True", "False")
# No large ones: who asks for 10⁹ steps shall have them.
COUNTS = ["-1", "0", "0.5", "nan", "None", "'1'", "Odd()", "[1]", "np.array(3)", "True"]
STEPS, REPETITIONS, EPISODES = (
    value(*good, other=COUNTS)
    for good in (("0", "1", "20"), ("1", "2"), ("1", "2", "None"))
)
METHOD = value(
    "'TOSL+QBIASSR'",
    "'Q+SR'",
    "'SL+EG'",
    "'SARSA+EGLE'",
    "'ESARSA+GREEDY'",
    "'SL+RANDOM'",
)
SEED = value("None", "0", "7", "np.random.SeedSequence(3)")
WORLD = value("'worked_example'", "task", "model", "'wander_simple'")
CHANGES = dict(
    alpha=value("0.1", "1"), temperature=value("1", "5e-324", "1e308"), epsilon=value("0.1", "0", "1"),
    accumulating=FLAG, loop_evasion=FLAG, r_max=value("1", "1e-320", "1e300"),
    planning_steps=value("0", "3", "-1"),
)  # fmt: skip
SETTINGS = CHANGES | dict(
    gamma=value("0.9", "0", "1 - 2**-53"),
    lam=value("0.9", "0", "1"),
    traces=value("'full'", "'reduced'"),
    planner=value("None", "'dyna'", "'dino'"),
)

agents = program(
    "agents", 12,
    call("agent = rl.Agent", WORLD, METHOD, seed=SEED, **SETTINGS),
    some(
        call("agent.begin_episode", STATE), call("agent.learn_step", STATE, ACTION, NUMBER, STATE, FLAG),
        call("agent.update", STATE, ACTION, NUMBER, STATE, ACTION, FLAG), call("agent.change", **CHANGES),
        "repr(agent)", "agent.policy, agent.bias, agent.shape", most=6,
    ),
    "usable_agent(agent, rl.make_env('wander_simple' if len(agent.shape) == 2 else model, 0))",
)  # fmt: skip

weak = call(
    "realism = rl.Realism",
    laser_noise=NUMBER,
    wheel_slip=NUMBER,
    delay=value("1", "5"),
)
environments = program(
    "environments", 9,
    weak | st.just("realism = None"),
    call(
        "env = rl.make_env", value("'worked_example'", "'wander_simple'", "model", "task"), SEED,
        render_mode=value("None"), engine=value("None", "'pymunk'", "'python'"), realism=value("realism"),
    ),
    some(
        call("env.reset", seed=SEED, options=value("None", "{}")), call("env.step", ACTION), "env = copy.deepcopy(env)",
        "env.close()", "env.reset()", most=7,
    ),
)  # fmt: skip

lying = call(
    "env = Foreign",
    shape=value("(2, 3)", "(6,)", "6", other=["(0, 2)", "(1,)", "1", "10**12", "(2**40, 3)", "(2**33, 2**33)"]),
    n=value("2", "1", other=["10**12"]),
    observation=value("None", other=[
        "np.array([1, 5])", "np.array([-1, 0])", "np.array([10**8, 0])", "np.array([0.5, nan])", "6", "-1", "2**62",
        "nan", "'x'", "np.array([0])", "np.array([0, 0, 0])", "[0, 1]", "(1, 1)", "np.array([[0, 1]])",
        "np.array([0, 1.0])", "np.uint8(3)", "{}", "Odd()", "1.5",
    ]),
    reward=value("1.0", "-1", other=[
        "nan", "inf", "None", "'x'", "[1]", "np.array(1.0)", "1e300", "10**400", "1j", "True", "np.array([1.0])",
        "Odd()",
    ]),
    terminated=value("False", "True", other=["None", "1", "'x'", "nan", "np.bool_(True)", "np.array([True, False])"]),
    info=value("None", other=[f"{{'state': {x}}}" for x in ("10**8", "-1", "'x'", "5", "None", "nan")] + ["'x'", "[]"]),
    drive=value("None", "lambda *_: 0", "3"), state=value("0", "None", "'x'", "10**9"),
    r_max=value("1", "0", "nan", "'x'"), episode_steps=value("None", "5", "0", "-1", "nan", "'x'", "2.5"),
    task=value("None", "'x'", "task"), model=value("model"),
)  # fmt: skip
space = st.sampled_from([
    "MultiDiscrete([2, 2])", "MultiDiscrete([2, 3])", "MultiDiscrete([2])", "Discrete(2)", "Discrete(3, start=5)",
    "Box(0, 1)", "MultiDiscrete([2, 2], start=[1, -1])", "MultiDiscrete([[2, 2]])", "Discrete(10**12)",
])  # fmt: skip
changed = st.sampled_from(
    ["o", "o[:2] // 2", "o[::-1]", "o + 1", "0", "o * nan", "7", "o[:1]", "None"]
)
wrapped = st.one_of(
    st.just(""),
    st.sampled_from(
        ["TimeLimit(env, 3)", "RecordEpisodeStatistics(env)", "OrderEnforcing(env)"]
    ),
    st.builds(
        "TransformObservation(env, lambda o: {}, gymnasium.spaces.{})".format,
        changed,
        space,
    ),
    st.sampled_from(["nan", "r * 1e300", "None", "int(r)"]).map(
        "TransformReward(env, lambda r: {})".format
    ),
).map(lambda made: made and f"env = gymnasium.wrappers.{made}")
learning = some(
    call("rl.learn", "agent", "env", STEPS, "progress=False", keep=FLAG, resume=FLAG, episodes=EPISODES),
    call("walk", "agent", "env", STEPS, resume=FLAG),
    call("rl.record", "env", "agent", value("1", "30", other=COUNTS)).map("{}.save('out')".format), most=3,
)  # fmt: skip
foreign = program(
    "foreign", 12,
    given(lying | st.just("env = rl.make_env('wander_simple', 0)")),
    given(wrapped),
    call("agent = rl.Agent", value("env"), METHOD, seed=SEED),
    "usable_agent(agent, env, 20)",
    learning,
)  # fmt: skip

methods = value(
    "['Q+SR']", "{'λ': {'method': 'SL+SR', 'lam': 0}}", "'Q+SR'", "['Q+SR', 'SARSA+EG']", "['Q+SR', 'Q+SR']",
    "{'_x': {}}", "{'x': None}", "{'x': {'method': 'Q+SR', 'seed': 3}}", "{3: {'method': 'Q+SR'}}",
)  # fmt: skip
jobs = st.sampled_from(
    ["n_jobs=1"] * 6 + ["n_jobs=0", "n_jobs=None", "n_jobs='x'", "n_jobs=1.5"]
)
compared = call(
    "result = rl.compare", value("model"), methods, "steps=20", "progress=False", jobs, repetitions=REPETITIONS,
    seed=SEED,
    episodes=EPISODES, keep=FLAG, store=value("None", "'out'", "'folder'", "'folder/file'"), **SETTINGS,
).map(lambda text: text if "repetitions=" in text else text.replace(" steps=", " repetitions=2, steps="))  # fmt: skip
experiments = program(
    "experiments", 5,
    st.sampled_from(["agent = rl.Agent(model, seed=0)", "agent = rl.Agent(model, 'SL+EG', accumulating=True)"]),
    "env = rl.make_env(model, 0)",
    learning,
    some(
        call("rl.repeat", value("model"), METHOD, "repetitions=2", "steps=20", jobs, seed=SEED, **SETTINGS),
        call("rl.repeat", value("model"), METHOD, "n_jobs=1", repetitions=REPETITIONS, steps=STEPS), most=1,
    ),
    compared,
    some(*(f"result.{end}" for end in ("anova()", "tukey()", "table()", "final", "optimum", "groups")), "repr(result)"),
)  # fmt: skip

TARGETS = [agents, environments, foreign, experiments]
