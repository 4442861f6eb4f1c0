"""A host for a robot with two driven wheels, which speaks as Corridor's relay does."""
