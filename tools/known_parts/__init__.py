"""Parts of sheet metal whose flat pattern is known by a formula. Folded in STEP; flat as numbers."""
