"""How the findings of figures are written."""


def as_sentence(text: str) -> str:
    """The text with a capital at its beginning, unless that is a symbol such as ε."""
    first = text[:1]
    if first.isascii():
        first = first.upper()
    return first + text[1:]
