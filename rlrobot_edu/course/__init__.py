"""What the lessons need and the library does not: exercises, figures, and things to play with.

lesson_01 … lesson_09: one room a lesson. `check` holds its exercises, `figures` its pictures; lessons import no lesson
grading: what all checks use, an exercise that names the first wrong step and gives a hint
stepper: any agent in any environment, one step at a time, forwards and backwards
bias_explorer: which states have a say in a choice of QBIASSR, and how much
sliders: sliders for an agent's parameters, and the learning curve that follows from them

Begin with the room of the lesson that you are in; a lesson's figures can be read beside its notebook, in its order.
"""
