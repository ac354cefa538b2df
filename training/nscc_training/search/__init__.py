"""Search of codes: change many places together, estimate in closed form, compare by a decoder.

A change of one place has almost no effect, and a pattern such as two phases of 2 x 2 is many such
changes away. Therefore `moves` changes blocks of a tile at once. `expected` estimates in
milliseconds how well a code captures moving light. `nscc_training.loop.steps` compares the most
promising codes by the run's decoder."""
