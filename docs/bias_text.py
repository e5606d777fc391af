"""The text of docs/bias.md. Its first part was written after looking at the outcomes; the tables say what they were."""

PAGE = """# Which bias helps, when, and how much?

{on_models}

{on_robots}

{figure}

{late}

{early}

{all_tests}

{missing}
"""
