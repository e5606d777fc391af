"""Pictures and widgets that explain: one file a subject of the course."""
