"""A host for a robot with two driven wheels. It implements the same API as Corridor's relay."""
