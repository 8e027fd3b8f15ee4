(expected: 2:1 T3 gives no turret place, only offset 3)
T3
M30
