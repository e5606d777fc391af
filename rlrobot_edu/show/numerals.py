"""How pictures write numbers: with a minus that is as long as a plus."""


def with_minus(number: float, digits: int = 0) -> str:
    """A number with so many digits behind the point."""
    return f"{number:.{digits}f}".replace("-", "−")


def signed(number: float) -> str:
    """A number with its sign, in four digits."""
    text = f"{abs(number):.4g}"
    if text == "0":
        return text
    return ("−" if number < 0 else "+") + text
