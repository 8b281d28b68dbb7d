// Which hit counts. labs/07_baking/baker.h includes this file, too.

const int take_nearest = 0, take_first = 1, take_last = 2;
