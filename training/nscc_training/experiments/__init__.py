"""The engine of sweeps, tradeoffs and evaluations.

`engine` computes tasks and stores their rows, `study` measures points and their times, and
`study_table` writes them as tables."""
