"""What Python's and numpy's error messages mean, in words for a beginner."""

# text of an exception (a regular expression) -> what it mostly means; the first that fits is told
MEANINGS = {
    # leaving, not coming back, not ready
    r"SystemExit": "exit() and quit() end the whole program. Leave a function with return.",
    r"RecursionError": "your function calls itself again and again, and nothing ends it.",
    r"NotImplementedError": "you have left this for later: now is the time.",
    # numbers
    r"ZeroDivisionError": "something is divided by 0 here. With these arguments, what stands below the line?",
    r"OverflowError|math range error": "a number too large for the computer, as e to the power of 710 is.",
    r"math domain error": "a logarithm or a root was taken of a number that has none.",
    r"operand type\(s\) for \^": "a power is written with two stars, as in gamma**k. ^ means something else in Python.",
    r"only (0-dim|length-1|size-1)": "math works on single numbers. For an array take np, as in np.exp.",
    r"must be real number, not (?P<what>\w+)": "a number is needed here, and a {what} was given.",
    r"cannot be interpreted as an integer": "a whole number is needed here. range wants a length: range(len(…)).",
    # None, and functions that are not called
    r"NoneType.*(not subscriptable|not iterable)|subscript.*NoneType": "None stands here where a value is needed. "
    "Did a function that you call return nothing? append, sort and reverse do: they change the list itself.",
    r"unsupported operand.*NoneType|NoneType.*unsupported": "None cannot be computed with. Did a function that you "
    "call return nothing?",
    r"unsupported operand.*(function|method)'": "a function stands here without the round brackets that call it.",
    # calls and names
    r"(?P<name>\w+) takes (?P<how>\(.*\))": "{name} is called with {how}: hand over just these, in this order.",
    r"(?P<name>\w+)\(\) (missing|takes|got)": "look at the call of {name}: which arguments does it take, and in which "
    "order?",
    r"'(?P<what>[\w.]+)' object is not callable": "round brackets call a function. A {what} is none: for an entry take "
    "square brackets.",
    r"'(?P<what>list|tuple)' object has no attribute '(?P<name>max|min|sum|mean|argmax)'": "a {what} has no .{name}(), "
    "only arrays have. Write {name}(…), or np.{name}(…).",
    r"'dict' object has no attribute '(?P<name>\w+)'": "an entry of a dictionary is written in square brackets, with "
    'quotation marks: ["{name}"].',
    r"'numpy' has no attribute '(?P<name>\w+)'": "numpy has nothing called {name}.",
    r"'(?P<what>[\w.]+)' object has no attribute '(?P<name>\w+)'": "a {what} has nothing called {name}. Is it spelled "
    "so, and is it what you think it is?",
    r"KeyError": "this key is not in the dictionary. Print its keys, and compare the spelling.",
    # one value where several are needed, and the other way round
    r"cannot unpack non-iterable (?P<what>\w+)": "to the left stand several names, to the right one {what}. Pairs come "
    "from enumerate(…) and zip(…).",
    r"not enough values to unpack|too many values to unpack": "to the left of = stand more or fewer names than there "
    "are values to the right.",
    r"'(int|float|numpy\.\w+)' object is not iterable": "for runs over a list, or over range(n). This is a single "
    "number.",
    r"object of type '(int|float|NoneType)' has no len": "only a list, an array or the like has a length. What stands "
    "in the brackets here is none.",
    r"object is not subscriptable": "square brackets take an entry out of a list or an array. What stands before them "
    "here is neither.",
    r"truth value of an array": "an array has many entries, and if needs one yes or no. Which entry do you mean?",
    r"setting an array element with a sequence": "a whole row stands where one number belongs. Is an index missing, "
    "or is it None?",
    r"invalid entry in coordinates": "a bin is beyond the last one: an input of n bins has the bins 0 to n − 1.",
    r"could not be broadcast|shape mismatch": "two arrays are combined that have different numbers of entries.",
    # lists
    r"only integer|indices must be integers": "an index is a whole number. Is it a reward, or a probability, that "
    "stands in the square brackets?",
    r"can't multiply sequence": "a list cannot be multiplied so. Make an array of it: np.array(…).",
    r"can only concatenate": "two kinds of things are put together with +, as a text and a number. Which is which?",
    r"unsupported operand.*'(list|set|tuple|dict)'|not supported between.*'(list|set|tuple|dict)'": "a whole list, or "
    "a set, stands here where a number is needed. Is an entry of it meant, or its size, len(…)?",
    r"not supported between instances of": "two things are compared that have no order, as a text and a number.",
    r"not in list": "remove(…) and index(…) look for a value, and it is not in the list.",
    r"unhashable": "a list cannot be in a set or be a key. Take its entries, or a tuple.",
    r"object does not support item assignment": "a tuple, or a text, cannot be changed. Make a list of it.",
    r"is empty|empty sequence|zero-size array": "this list is empty here, and has no largest, smallest or first entry.",
}
