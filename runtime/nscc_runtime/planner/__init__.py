"""Plans: which effects of the sensor a run simulates, and how, to a tolerance."""
