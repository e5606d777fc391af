"""First answers of a chat bot to the exercises, written from the text of the exercise alone and never mended.

A large language model was given the last 900 characters of text above each exercise and the first lines of its function
(in December 2026). It saw no check and no world, and no solution but those of lesson 03. `lessons` and `assignments`
hold what it wrote; ``python studies/ai_assistants.py`` judges that and writes the table of docs/ai_assistants.md.
"""
