"""Programs for chips without logic: which tap takes whose light, when planes load, what is sent."""
