"""What Python's and numpy's error messages mean, in words for a beginner."""

IN = ", in the line: "  # between an exception's text and the learner's line, for meanings that depend on both

# text of an exception, and its line (a regular expression) -> what it mostly means; the first that fits is told
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
    r"operand type\(s\) for [&|]|bitwise_(and|or)": "conditions are joined with and and or. & and | join bits.",
    r"operand type\(s\) for .*'range'": "a range cannot be computed with as a whole. Take its numbers one by one in a "
    "loop, or an array of them, np.arange(n).",
    r"matmul|operand type\(s\) for @": "@ multiplies matrices. To multiply entry by entry, write *.",
    r"only (0-dim|length-1|size-1)": "math, int and float work on single numbers. For an array take np, as in np.exp.",
    r"must be real number, not (?P<what>\w+)": "a number is needed here, and a {what} was given.",
    r"'float' object cannot be interpreted as an integer": "a whole number is needed here. / gives numbers with a "
    "fraction, // whole ones.",
    r"'(?P<what>[\w.]+)' object cannot be interpreted as an integer": "a whole number is needed here, and this is a "
    "{what}. Is one of its entries meant, as in n[i], or its length, len(…)?",
    r"as a data type": "the numbers of rows and columns belong together, in brackets of their own: "
    "np.zeros((rows, columns)).",
    r"return arrays must be of ArrayType": "this function of numpy takes one argument. (np.log is to base e already.)",
    # None, and functions that are not called
    r"'NoneType' object has no attribute '(append|sort|reverse|extend|remove|insert)'": "None stands before the point. "
    "append, sort and their like change the list and return nothing: write numbers.append(…), without numbers = .",
    r"'NoneType' object has no attribute": "None stands before the point. Did a function that you call return nothing?",
    r"NoneType.*(not subscriptable|not iterable)|subscript.*NoneType": "None stands here where a value is needed. "
    "Did a function that you call return nothing? append, sort and reverse do: they change the list itself.",
    r"unsupported operand.*NoneType|NoneType.*unsupported": "None cannot be computed with. Did a function that you "
    "call return nothing?",
    r"not supported between.*NoneType": "None cannot be compared. Did a function that you call return nothing?",
    r"'(builtin_)?(function|method)\w*' object is not (subscriptable|iterable)": "a function is called with round "
    "brackets; square ones take an entry out of a list.",
    r"(unsupported operand|not supported between|bad operand).*(function|method|function_or_method)'": "a function "
    "stands here without the round brackets that call it.",
    r"'((builtin_)?(function|method)\w*|numpy\.ufunc)' object has no attribute": "a function stands before the point "
    "without the round brackets that call it.",
    # calls and names
    r"(?P<name>\w+) takes (?P<how>\(.*\)), in this order": "{name} is called with {how}: hand over just these, in this "
    "order.",
    r"(?P<name>\w+)\(\) (missing|takes|got)": "look at the call of {name}: which arguments does it take, and in which "
    "order?",
    r"'(?P<what>[\w.]+)' object is not callable": "round brackets call a function. A {what} is none: for an entry take "
    "square brackets, and to multiply, a star.",
    r"'(?P<what>list|tuple)' object has no attribute '(?P<name>max|min|sum|mean|argmax)'": "a {what} has no .{name}(), "
    "only arrays have. Write {name}(…), or np.{name}(…).",
    r"'numpy.ndarray' object has no attribute '(?P<name>append|index|count)'": "an array has nothing called {name}, "
    "only lists have.",
    r"'numpy.ndarray' object has no attribute '(?P<name>exp|log|len|sqrt|abs)'": "an array has nothing called {name}: "
    "write np.{name}(…), and its length as len(…).",
    r"'dict' object has no attribute '(?P<name>\w+)'": "an entry of a dictionary is written in square brackets, with "
    'quotation marks: ["{name}"].',
    r"module '(?P<what>[\w.]+)' has no attribute '(?P<name>\w+)'": "{what} has nothing called {name}.",
    r"'(?P<what>[\w.]+)' object has no attribute '(?P<name>\w+)'": "a {what} has nothing called {name}. Is it spelled "
    "so, and is it what you think it is?",
    r"KeyError": "this key is not in the dictionary. Print its keys, and compare the spelling.",
    # one value where several are needed, and the other way round
    rf"(cannot unpack|values to unpack).*{IN}.*\bfor \w+, *\w+ in \w+, *\w+": "two lists are gone through together "
    "with zip: for b, n in zip(bins, shape).",
    r"cannot unpack non-iterable (builtin_)?(function|method)": "to the right stands a function without the round "
    "brackets that call it.",
    r"cannot unpack non-iterable (?P<what>\w+)": "to the left stand several names, to the right one {what}. Pairs come "
    "from enumerate(…) and zip(…).",
    rf"values to unpack.*{IN}.*\bfor ": "there are more or fewer names after for than values in each entry. Pairs come "
    "from enumerate(…) and zip(…).",
    r"not enough values to unpack|too many values to unpack": "to the left of = stand more or fewer names than there "
    "are values to the right.",
    rf"object is not iterable{IN}.*\.extend\(": "extend takes a whole list. A single item is added with append.",
    rf"object is not iterable{IN}.*\b(?P<name>max|min|sum)\(": "{name} takes several numbers, as a whole row, and this "
    "is a single one.",
    r"'(int|float|numpy\.\w+)' object is not iterable": "for runs over a list, or over range(n). This is a single "
    "number.",
    r"object of type '(int|float|NoneType)' has no len": "only a list, an array or the like has a length. What stands "
    "in the brackets here is none.",
    r"object is not subscriptable": "square brackets take an entry out of a list or an array. What stands before them "
    "here is neither.",
    rf"truth value of an array.*{IN}.*\b(?P<name>max|min|sorted)\(": "{name} compares one number with another, and "
    "here these are whole rows. Hand it a single row.",
    r"truth value of an array": "an array has many entries, and if needs one yes or no. Which entry do you mean?",
    r"setting an array element with a sequence|inhomogeneous": "a whole row stands where one number belongs. Is an "
    "index missing, or is it None?",
    r"invalid entry in coordinates": "a bin is beyond the last one: an input of n bins has the bins 0 to n − 1.",
    r"out of bounds for array with size (?P<n>\d+)": "there are {n} states here, numbered from 0.",
    r"could not be broadcast|shape mismatch|not aligned|doesn't match the broadcast": "two arrays are combined that "
    "have different numbers of entries.",
    # lists
    r"only integer|indices must be integers": "an index is a whole number. What is it that stands in the square "
    "brackets here?",
    r"can't multiply sequence": "a whole list is multiplied here. Is one of its entries meant, as in rewards[k]? (Only "
    "an array, np.array(…), can be multiplied as a whole.)",
    r"can only concatenate": "two kinds of things are put together with +, as a text and a number, or a list and a "
    "number. Which is which?",
    r"unsupported operand.*'str'|not supported between.*'str'": "there is text here, where a number is needed. Leave "
    "out the quotation marks.",
    r"unsupported operand.*'(list|set|tuple|dict)'|not supported between.*'(list|set|tuple|dict)'": "a whole list, or "
    "a set, stands here where a number is needed. Is an entry of it meant, or its size, len(…)?",
    r"not supported between instances of": "two things are compared that have no order.",
    r"not in list": "remove(…) and index(…) look for a value, and it is not in the list.",
    r"unhashable": "a list cannot be in a set or be a key. Take its entries, or a tuple.",
    r"'(int|float|numpy\.\w+)' object does not support item assignment": "this is a single number and has no entries. "
    "Make an array of the right length first, as with np.zeros(n).",
    r"object does not support item assignment": "a tuple, or a text, cannot be changed. Make a list of it.",
    r"is empty|empty sequence|zero-size array": "this list is empty here, and has no largest, smallest or first entry.",
}
