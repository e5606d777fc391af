"""Open challenge of lesson 18: fast and safe where a robot slips and walls hold it."""

from typing import Any

from rlrobot_course.play.challenge import Challenge, Watched, number
from rlrobot_course.worlds.own_reward import OwnReward, Readings
from rlrobot_edu import Agent, Realism, learn, make_env
from rlrobot_edu.task.rewards import distance_moved

STOPS_OR_TURNS = {1, 2, 3, 4, 6}  # actions of wander_1k that do not drive
REALITY = Realism(laser_noise=0.03, wheel_slip=0.1, lag=0.3, wall_friction=0.72)


class Guarded(OwnReward):
    """A robot whose actions a guard may replace; `metres` are the way of each step, and −0.1 for one that touches."""

    def __init__(self, env: Any, guard: Watched) -> None:
        super().__init__(env, self._measure)
        self.guard, self.metres = guard, list[float]()

    def step(self, action: int) -> Any:
        done = self.guard(dict(self._readings), int(action))
        if done not in {action, *STOPS_OR_TURNS}:
            raise ValueError(
                f"a guard lets {action} pass, stops (1, 3, 4) or turns (2, 6); yours returns {done:g}"
            )
        return super().step(int(done))

    def _measure(
        self, before: Readings, after: Readings, r: float, terminated: bool
    ) -> float:
        way = distance_moved(before, after)
        touches = (
            min(after[laser] for laser in after if laser.startswith("laser")) < 0.05
        )
        self.metres.append(-0.1 if touches else way * (way > 0.07))
        return r


def metres(guard: Watched, seed: int) -> float:
    """The way in 100 steps after 800 steps of learning in the ideal simulator, 0.1 m less a touch [m]."""
    agent = Agent("wander_1k", seed=seed)
    learn(
        agent,
        Guarded(make_env("wander_1k", seed=seed), guard),
        steps=800,
        progress=False,
    )
    real = Guarded(make_env("wander_1k", seed=seed, realism=REALITY), guard)
    learn(agent, real, steps=100, progress=False)
    return float(sum(real.metres))


challenge = Challenge(
    "18",
    "Write my_guard(readings, a): it returns a, or what is done in its place: 4 stops, 2 turns left, 6 turns right. "
    "A robot of wander_1k learns with it for 800 steps in the ideal simulator. Then it drives 100 steps where it "
    "slips and walls hold it. What counts is how far it gets in steps of more than 0.07 m; each step that ends 0.05 m "
    "from a wall costs 0.1 m.",
    "m in 100 steps", lambda guard: Watched(guard, "my_guard(readings, a)", number(0, 8)), metres,
)  # fmt: skip
