"""Make the pictures of the README: ``make pictures``. The same pictures every time."""

from pathlib import Path

import rlrobot_edu as rl

HERE = Path(__file__).parent / "pictures"

env = rl.make_env("wander_1k", seed=0)
agent = rl.Agent("wander_1k", "TOSL+QBIASSR", seed=0)
history = rl.learn(agent, env, steps=3600, progress=False)
rl.film(agent, env, steps=100).gif(HERE / "wander_1k.gif")

curves = [rl.repeat("wander_1k", method, repetitions=30, steps=3600) for method in ("TOSL+QBIASSR", "TOSL+SR", "Q+SR")]
figure = rl.plot_learning(*curves, title="wander_1k on the simulated robot: one hour of learning")
figure.savefig(HERE / "methods.png", dpi=90, metadata={"Software": None})
print("wander_1k.gif and methods.png:", figure.alt)
