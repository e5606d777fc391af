"""Modules that import one another cannot be read one after the other: few do, and these are listed."""

import grimp
import numpy as np
from scipy import sparse

# A film shows itself in 3D, by an import that waits until it is asked to.
CIRCLES = [{"show.film", "view3d.views"}]
BELOW = (
    "task", "learning", "robots", "models", "experiments", "show", "bullet", "kinematic", "crediting", "view3d", "live",
    "environments", "files", "seeds",
)  # fmt: skip


def test_no_other_modules_of_the_library_import_one_another():
    graph = grimp.build_graph("rlrobot_edu", cache_dir=None, exclude_type_checking_imports=True)
    modules = sorted(m for m in graph.modules if m.startswith(tuple(f"rlrobot_edu.{room}" for room in BELOW)))
    number = {module: i for i, module in enumerate(modules)}
    pairs = [(number[m], number[n]) for m in modules for n in graph.find_modules_directly_imported_by(m) if n in number]
    edges = sparse.csr_array((np.ones(len(pairs)), tuple(np.transpose(pairs))), shape=(len(modules),) * 2)
    n, group = sparse.csgraph.connected_components(edges, directed=True, connection="strong")
    circles = [{m.removeprefix("rlrobot_edu.") for m in modules if group[number[m]] == i} for i in range(n)]
    assert sorted(filter(lambda circle: len(circle) > 1, circles), key=min) == CIRCLES
