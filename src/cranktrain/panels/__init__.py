"""Pictures as data, which any face draws: curves, polar diagrams, bars, rays, shapes; drawings of mechanisms."""
