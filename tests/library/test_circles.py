"""Modules that import one another cannot be read one after the other."""

import grimp
import numpy as np
from scipy import sparse

BELOW = (
    "task",
    "learning",
    "robots",
    "models",
    "experiments",
    "show",
    "tools",
    "environments",
    "files",
    "checks",
    "jit",
    "seeds",
)


def test_no_modules_of_the_library_import_one_another():
    graph = grimp.build_graph(
        "rlrobot_edu", cache_dir=None, exclude_type_checking_imports=False
    )
    modules = sorted(
        m
        for m in graph.modules
        if m.startswith(tuple(f"rlrobot_edu.{room}" for room in BELOW))
    )
    number = {module: i for i, module in enumerate(modules)}
    pairs = [
        (number[m], number[n])
        for m in modules
        for n in graph.find_modules_directly_imported_by(m)
        if n in number
    ]
    edges = sparse.csr_array(
        (np.ones(len(pairs)), tuple(np.transpose(pairs))), shape=(len(modules),) * 2
    )
    n, group = sparse.csgraph.connected_components(
        edges, directed=True, connection="strong"
    )
    circles = [
        {m.removeprefix("rlrobot_edu.") for m in modules if group[number[m]] == i}
        for i in range(n)
    ]
    assert [circle for circle in circles if len(circle) > 1] == []
