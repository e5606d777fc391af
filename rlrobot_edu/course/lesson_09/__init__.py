"""Lesson 09. All pieces together, TOSL+QBIASSR, and a fair comparison of methods."""
