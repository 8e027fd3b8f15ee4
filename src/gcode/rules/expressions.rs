//! What is wrong with expressions, parameters, inputs and outputs.

use crate::finding::Example;
use crate::finding::rule::rules;

rules! {
    /// The rows of this file.
    RULES;

    "G0201" NotFinite Stop {}
        es "el resultado no es un número finito"
        en "the result is not a finite number"
        remedy "corrija la expresión", "correct the expression";
        why "Un número infinito no es una posición.",
            "An infinite number is not a position.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[10**400]|M2", "2:8");
    "G0202" NegativePower Stop {}
        es "número negativo elevado a un exponente que no es entero"
        en "negative number raised to a power that is not whole"
        remedy "corrija la expresión", "correct the expression";
        why "El resultado no es un número real.",
            "The result is not a real number.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[[0-2]**0.5]|M2", "2:11");
    "G0203" DivisionByZero Stop {}
        es "división por cero"
        en "division by zero"
        remedy "corrija la expresión", "correct the expression";
        why "La expresión no tiene resultado y el control se para.",
            "The expression has no result, and the control stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1/0]|M2", "2:7");
    "G0204" TwoSigns Stop {}
        es "número con dos signos"
        en "number with two signs"
        remedy "deje un solo signo", "leave one sign";
        why "No se sabe si se quieren los dos signos o si uno sobra.",
            "It is not clear whether both signs are meant or one is a slip.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X--1|M2", "2:5");
    "G0205" TooDeep Stop { most: usize }
        es "expresión con más de {most} niveles"
        en "expression nested more than {most} deep"
        remedy "divídala con parámetros", "split it with parameters";
        why "El control tampoco admite más niveles.",
            "The control does not take more nested levels either.";
        example Example::program("linuxcnc", "G0 X[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]]|M2", "1:69");
    "G0206" BracketMissing Stop {}
        es "falta «[»"
        en "'[' is missing"
        remedy "ponga la expresión entre corchetes", "put the expression in brackets";
        why "Sin corchetes no se sabe dónde empieza y acaba la condición.",
            "Without brackets it is not clear where the condition begins and ends.";
        example Example::program("linuxcnc", "G21 G90 F100|O1 IF 1|O1 ENDIF|M2", "2:6");
    "G0207" ExpressionOpen Stop {}
        es "expresión sin cerrar"
        en "unclosed expression"
        remedy "ciérrela con «]»", "close it with ']'";
        why "Sin el corchete de cierre no se sabe dónde acaba la expresión.",
            "Without the closing bracket it is not clear where the expression ends.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1+2|M2", "2:5");
    "G0208" OperatorUnknown Stop {}
        es "operador desconocido"
        en "unknown operator"
        remedy "corrija la expresión", "correct the expression";
        why "Un operador desconocido no da ningún resultado.",
            "An unknown operator gives no result.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1 foo 2]|M2", "2:7");
    "G0209" FunctionUndefined Stop { function: String, argument: f64 }
        es "{function} no está definida para {argument}"
        en "{function} is not defined for {argument}"
        remedy "corrija la expresión", "correct the expression";
        why "Fuera de su dominio la función no tiene valor, y el control se para.",
            "Outside its domain the function has no value, and the control stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[ACOS[2]]|M2", "2:6");
    "G0210" AtanWithoutSlash Stop {}
        es "falta «/» en ATAN[y]/[x]"
        en "'/' is missing in ATAN[y]/[x]"
        remedy "escriba ATAN[y]/[x]", "write ATAN[y]/[x]";
        why "ATAN necesita las dos coordenadas para saber el cuadrante.",
            "ATAN needs both coordinates to know the quadrant.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[ATAN[1]]|M2", "2:13");
    "G0211" Exists Stop {}
        es "EXISTS espera un parámetro: EXISTS[#<nombre>]"
        en "EXISTS needs a parameter: EXISTS[#<name>]"
        remedy "escriba EXISTS[#<nombre>]", "write EXISTS[#<name>]";
        why "EXISTS pregunta por un parámetro, no por un valor.",
            "EXISTS asks for a parameter, not for a value.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[EXISTS[1]]|M2", "2:12");
    "G0212" NameUnset Stop { name: String }
        es "el parámetro #<{name}> no está definido"
        en "parameter #<{name}> is not defined"
        remedy "dele un valor antes de usarlo", "give it a value before it is used";
        why "Un parámetro con nombre no tiene valor hasta que el programa se lo da.",
            "A named parameter has no value until the program sets it.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#<nowhere>|M2", "2:5");
    "G0213" InputUsed Stop { number: usize }
        es "#{number} es lo que M66 ha leído de una entrada: el programa no lo contiene"
        en "#{number} is what M66 read from an input: the program does not contain it"
        remedy "para comprobar el programa, escriba en su lugar el valor esperado", "to verify the program, write the expected value instead";
        why "El programa depende de lo que lea la entrada de la máquina, y rodete no puede saberlo.",
            "The program depends on what the machine's input reads, and rodete cannot know that.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 P0|G0 X#5399|M2", "3:5");
    "G0214" ParameterUnset Caution { number: usize }
        es "el parámetro #{number} no tiene valor: vale 0"
        en "parameter #{number} was never set: it counts as 0"
        remedy "dele un valor antes de usarlo", "give it a value before it is used";
        why "Si el control guarda en él un valor anterior, el programa hace otra cosa.",
            "If the control still holds an earlier value in it, the program does something else.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#31|M2", "2:5");
    "G0215" EqualsMissing Stop {}
        es "falta «=» tras el parámetro"
        en "'=' is missing after the parameter"
        remedy "escriba #1=2", "write #1=2";
        why "Un parámetro al principio de una palabra solo puede recibir un valor: #1=2.",
            "A parameter at the beginning of a word can only take a value: #1=2.";
        example Example::program("linuxcnc", "G21 G90 F100|#1 X2|M2", "2:4");
    "G0216" ValueMissing Stop {}
        es "falta un valor delante de «]»"
        en "a value is missing before ']'"
        remedy "complete la expresión", "complete the expression";
        why "A la expresión le falta el último valor.",
            "The last value of the expression is missing.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[1+]|M2", "2:8");
    "G0217" FunctionUnknown Stop {}
        es "función desconocida"
        en "unknown function"
        remedy "use ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT o TAN", "use ABS, ACOS, ASIN, ATAN, COS, EXISTS, EXP, FIX, FUP, LN, ROUND, SIN, SQRT or TAN";
        why "Una función mal escrita no da ningún número.",
            "A misspelt function gives no number.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X[SINE[1]]|M2", "2:6");
    "G0218" ParameterOutOfRange Stop { number: f64, most: usize }
        es "no hay parámetro #{number}"
        en "there is no parameter #{number}"
        remedy "use #1 a #{most}", "use #1 to #{most}";
        why "El control no tiene ese parámetro y se para.",
            "The control has no such parameter and stops.";
        example Example::program("linuxcnc", "G21 G90 F100|G0 X#5602|M2", "2:5");
    "G0219" ParameterReadOnly Stop { name: String }
        es "el parámetro {name} es de solo lectura"
        en "parameter {name} is read-only"
        remedy "use otro parámetro", "use another parameter";
        why "El control lo calcula él mismo y no deja cambiarlo.",
            "The control computes it itself and does not let it be changed.";
        example Example::program("linuxcnc", "G21 G90 F100|#5420=1|M2", "2:1");
    "G0220" OutputWithoutNumber Stop {}
        es "salida digital sin número P"
        en "digital output without a number P"
        remedy "P es el número de la salida, entero de 0 en adelante", "P is the output's number, whole, from 0 on";
        why "No se sabe de qué salida se trata.",
            "It is not clear which output is meant.";
        example Example::program("linuxcnc", "G21 G90 F100|M62|M2", "2:1");
    "G0221" AnalogOutputIncomplete Stop {}
        es "salida analógica sin número E o sin Q"
        en "analog output without a number E, or without Q"
        remedy "E es el número de la salida, entero de 0 en adelante; Q, su valor", "E is the output's number, whole, from 0 on; Q is its value";
        why "Sin número o sin valor no se sabe qué ha de hacer la salida.",
            "Without a number or a value it is not clear what the output should do.";
        example Example::program("linuxcnc", "G21 G90 F100|M67 E0|M2", "2:1");
    "G0222" InputNeither Stop {}
        es "M66 necesita P o E"
        en "M66 needs either P or E"
        remedy "P es el número de una entrada digital y E el de una analógica, entero de 0 en adelante", "P is the number of a digital input, E that of an analog one, whole, from 0 on";
        why "M66 lee una sola entrada: con dos, o con ninguna, no se sabe cuál.",
            "M66 reads one input: with two, or none, it is not clear which.";
        example Example::program("linuxcnc", "G21 G90 F100|M66|M2", "2:1");
    "G0223" InputWaitUnknown Stop {}
        es "L de M66 no es un modo de espera"
        en "L of M66 is not a wait mode"
        remedy "L es 0, 1, 2, 3 o 4", "L is 0, 1, 2, 3 or 4";
        why "El control no conoce ese modo de espera.",
            "The control does not know this wait mode.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 P0 L9|M2", "2:1");
    "G0224" InputAnalogWait Stop {}
        es "M66 con E espera a una entrada analógica"
        en "M66 with E waits for an analog input"
        remedy "una entrada analógica solo se puede leer: escriba L0", "an analog input can only be read: write L0";
        why "Una entrada analógica no tiene flanco al que esperar.",
            "An analog input has no edge to wait for.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 E0 L3 Q1|M2", "2:1");
    "G0225" InputWithoutTime Stop {}
        es "M66 espera, pero no da el tiempo Q"
        en "M66 waits but gives no time Q"
        remedy "dé Q en segundos, mayor que 0", "give Q in seconds, greater than 0";
        why "Sin tiempo el control no esperaría nada.",
            "Without a time the control would not wait at all.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 P0 L3|M2", "2:1");
    "G0226" InputRead Note {}
        es "M66 lee una entrada de la máquina"
        en "M66 reads an input of the machine"
        remedy "", "";
        why "Lo que haga el programa después puede depender de la entrada.",
            "What the program does afterwards may depend on the input.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 P0|M2", "2:1");
    "G0227" InputWaited Note {}
        es "M66 espera a una entrada: el tiempo total no incluye esa espera"
        en "M66 waits for an input: the total time leaves that wait out"
        remedy "", "";
        why "No se sabe de antemano cuánto tarda la entrada.",
            "Nobody knows beforehand how long the input takes.";
        example Example::program("linuxcnc", "G21 G90 F100|M66 P0 L3 Q1|M2", "2:1");
    "G0228" NameOfMachine Stop { name: String }
        es "#<{name}> depende de la máquina: rodete no lo conoce"
        en "#<{name}> depends on the machine: rodete does not know it"
        remedy "quítelo, o compruebe el programa con el valor escrito en su lugar", "leave it out, or verify the program with its value in place of it";
        why "El valor lo ponen la máquina, su operario o la versión del control.",
            "The machine, its operator or the control's version gives the value.";
        example Example::program("linuxcnc", "G21 G90 F100|G1 X#<_flood>|M2", "2:5");
}
