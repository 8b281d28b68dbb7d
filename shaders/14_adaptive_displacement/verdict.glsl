// The verdict on a patch.

const int verdict_drawn = 0, verdict_outside = 1, verdict_away = 2;
