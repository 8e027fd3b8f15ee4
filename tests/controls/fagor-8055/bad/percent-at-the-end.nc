%P,MX,
;expected: 4:1 '%' is not allowed here
N10 G71 G90 G0 X1
%
