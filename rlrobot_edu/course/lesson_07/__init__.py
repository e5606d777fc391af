"""Lesson 07. QBIASSR: similar states lend their experience."""
