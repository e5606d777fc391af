"""Which cells of a notebook depend on which; the site and the tests use this to run a part of a notebook."""

import ast
import symtable


def names_in(source: str) -> tuple[set[str], set[str]]:
    """Names that a cell takes from elsewhere, its functions' too, and names that it gives a value."""
    taken, given = set(), set()
    if source.startswith("%%"):  # it writes a file
        return taken, given
    for line in ast.parse(source).body:
        table = symtable.symtable(ast.unparse(line), "cell", "exec")
        changed = {
            it.target.id
            for it in ast.walk(line)
            if isinstance(it, ast.AugAssign) and hasattr(it.target, "id")
        }
        taken |= (
            names_read(table) | changed
        ) - given  # symtable does not call the x of x += 1 read
        given |= {
            name.get_name()
            for name in table.get_symbols()
            if name.is_assigned() or name.is_imported()
        }
    return taken, given


def names_read(table: symtable.SymbolTable) -> set[str]:
    """The global names that a piece of code, or a function in it, reads."""
    own = {
        name.get_name()
        for name in table.get_symbols()
        if name.is_global() and name.is_referenced()
    }
    return own.union(*map(names_read, table.get_children()))


def needed_by(source: str, before: list[str]) -> list[str]:
    """Of the cells `before` it, in their order, those that give a value to what the cell `source` takes."""
    needed, cells = names_in(source)[0], []
    for earlier in reversed(before):
        taken, given = names_in(earlier)
        if given & needed:
            needed = (needed - given) | taken
            cells.insert(0, earlier)
    return cells
