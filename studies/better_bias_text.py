"""The text of docs/a_better_bias.md. What judges was written after looking at the numbers; tables are computed."""

PAGE = """# x

{means} {best} {forest} {by_temperature} {tests_a} {verdicts_a} {checks} {changed} {tests_c} {verdicts_c} {others}
{best_others} {tests_b} {verdicts_b} {relatives} {rule_says} {wheels} {wheels_tests} {rules} {seed}
"""
