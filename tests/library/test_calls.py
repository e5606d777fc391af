"""Every public call does what its docstring says, or refuses in one sentence."""

import ast
import re
from pathlib import Path

import pytest

import rlrobot_edu as rl


def learned(method="TOSL+SR", **settings):
    agent = rl.Agent("wander_simple", method, seed=0, **settings)
    rl.learn(agent, rl.make_env("wander_simple", seed=0), steps=40, progress=False)
    return agent


def temperatures(agent, steps=3):
    return [
        step.temperature
        for step in rl.steps(agent, rl.make_env("wander_simple", seed=1), steps=steps)
    ]


def test_a_changed_temperature_is_that_of_the_next_choices_with_loop_evasion_or_without():
    for loop_evasion in (True, False):
        agent = learned(loop_evasion=loop_evasion)
        agent.change(temperature=3)
        assert temperatures(agent, 1) == [3]
        agent = learned(loop_evasion=loop_evasion)
        env = rl.make_env("wander_simple", seed=1)
        rl.learn(agent, env, steps=2, progress=False)
        agent.change(temperature=3)
        assert [
            step.temperature for step in rl.steps(agent, env, steps=3, resume=True)
        ][1:] == [3, 3]


def test_without_loop_evasion_the_temperature_that_a_loop_has_raised_falls_back():
    agent = rl.Agent("wander_simple", "TOSL+SR", seed=0)
    agent.begin_episode(0)
    for _ in range(30):  # a loop through one state, for nothing
        agent.learn_step(0, 0, -1.0, 0, False)
    assert agent.memory.now.temperature > 1
    agent.change(loop_evasion=False)
    agent.learn_step(0, 0, -1.0, 0, False)
    assert agent.memory.now.temperature == 1


def test_what_an_agent_is_not_given_it_cannot_be_changed_to():
    agent = rl.Agent("wander_simple", "TOSL+SR")
    with pytest.raises(ValueError, match=r"a variant of SARSA\(lambda\), not of"):
        agent.change(accumulating=True)
    for fixed in ({"seed": 1}, {"method": "Q+SR"}, {"gamma": 0.5}):
        with pytest.raises(ValueError, match="cannot be changed later; make a new"):
            agent.change(**fixed)
    with pytest.raises(ValueError, match="did you mean 'temperature'"):
        agent.change(temprature=2)


def test_a_sample_model_takes_no_engine_and_no_options_of_a_robot(wander_model):
    for wrong in ({"engine": "nonsense"}, {"engine": "pymunk"}):
        with pytest.raises(ValueError, match="only a task has a robot: leave engine"):
            rl.make_env(wander_model, **wrong)
    for wrong in ({"speed": 2}, {"render_mode": "rgb_array"}):
        with pytest.raises(TypeError, match=next(iter(wrong))):
            rl.make_env(wander_model, **wrong)
    with pytest.raises(ValueError, match="only a task has a robot"):
        rl.compare(wander_model, ["Q+SR"], 1, steps=10, engine="pymunk", progress=False)


def test_unknown_settings_are_refused_and_the_nearest_one_suggested():
    some = {"repetitions": 1, "steps": 5, "progress": False}
    for run in (lambda **more: rl.compare("wander_simple", ["Q+SR"], **some, **more),
                lambda **more: rl.repeat("wander_simple", "Q+SR", **some, **more),
                lambda **more: rl.compare("wander_simple", {"mine": {"method": "Q+SR", **more}}, **some)):  # fmt: skip
        with pytest.raises(
            ValueError, match="no setting 'temprature'; did you mean 'temperature'"
        ):
            run(temprature=2)
    with pytest.raises(ValueError, match="a seed of its own"):
        rl.compare("wander_simple", {"mine": {"method": "Q+SR", "seed": 3}}, **some)


def test_whatever_takes_agent_and_environment_says_in_which_order():
    agent, env = rl.Agent("wander_simple"), rl.make_env("wander_simple")
    for call in (
        rl.learn,
        rl.evaluate,
        rl.steps,
        rl.record,
        rl.film,
        rl.watch,
        rl.Stepper,
    ):
        with pytest.raises(ValueError, match=r"[Aa]gent and an environment"):
            call(env, agent, *([5] if call is not rl.Stepper else []))
    with pytest.raises(ValueError, match="got Agent and Agent"):
        rl.record(agent, agent, steps=5)


def test_no_film_is_empty_and_no_average_of_nothing_is_asked_for():
    agent, env = rl.Agent("wander_simple"), rl.make_env("wander_simple")
    with pytest.raises(ValueError, match="steps must be a whole number of at least 1"):
        rl.watch(agent, env, steps=0)
    with pytest.raises(ValueError, match="steps must be a whole number of at least 1"):
        rl.film(agent, env, steps=0)
    film = rl.film(agent, env, steps=1)
    with pytest.raises(ValueError, match="a film without steps"):
        type(film)([], [])
    nothing = rl.learn(agent, env, steps=0, progress=False)
    assert len(nothing.average_reward) == 0 and "0 steps" in repr(nothing)
    with pytest.raises(
        ValueError, match="a history without steps has no average reward"
    ):
        nothing.final_average_reward  # noqa: B018


def test_an_episode_of_a_model_that_is_over_time_is_cut_off_however_it_got_there():
    model = rl.SampleModel.from_recording(rl.read_recording("arm_1k"))
    env = rl.make_env(model, seed=0)
    env.reset()
    env.episode_step = model.episode_steps + 5  # as one that is resumed may be
    assert env.step(0)[3]


PACKAGE = Path(rl.__file__).parent
FOLDERS = sorted(
    path.parent.relative_to(PACKAGE).as_posix()
    for path in PACKAGE.glob("*/**/__init__.py")
)


@pytest.mark.parametrize("folder", FOLDERS)
def test_the_page_of_a_folder_names_all_its_files(folder):
    page = ast.get_docstring(
        ast.parse((PACKAGE / folder / "__init__.py").read_text(encoding="utf-8"))
    )
    inside = {path.stem for path in (PACKAGE / folder).glob("*.py")} | {
        path.parent.name for path in (PACKAGE / folder).glob("*/__init__.py")
    }
    assert not [
        name
        for name in sorted(inside - {"__init__"})
        if not re.search(rf"\b{name}\b", page)
    ]
