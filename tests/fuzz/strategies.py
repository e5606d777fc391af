"""How a valid file is damaged: its bytes, its JSON, its arrays, the members of its archive, the header of an array."""

from __future__ import annotations

import copy
import io
import json
import struct
import zipfile
import zlib
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from hypothesis import strategies as st

Draw = Callable[[st.SearchStrategy], Any]

# What somebody may find in the middle of a file.
TOKENS = [
    b"nan", b"inf", b"-1", b"1e999", b"1_0", "١".encode(), b"9" * 400, b"0x1", b"\x00", b"\xff\xfe", b'"', b"'", b",",
    b"\n",
    b"\r\n", b"\r", b"\xef\xbb\xbf", b"null", b"[" * 3000, b"{", b"}", b" ", b"#", b"(" * 300, b"PK\x03\x04", b"-0",
    b"True",
]  # fmt: skip

JSON_VALUES = [
    None, True, False, 0, 1, -1, 2, 3, 24, 0.5, -0.0, 1e308, 5e-324, 10**9, 2**31, 2**62, 2**63, 10**30, 10**400,
    float("nan"),
    float("inf"), "", "x", "1", "Q+SR", "worked_example", "é" * 500, "\x00", "a\nb", "../../x", "<b>", "\ud800", [],
    [0], [1, 2],
    [1e308], [None], ["x"], [[1]], [10**30], {}, {"x": 1}, [0] * 1000, "x" * 5000,
]  # fmt: skip

NUMBERS = [
    0, 1, -1, 2, 3, 24, 71, 72, 73, 127, 1000, 10**8, 10**9, 2**31, 2**62, -(2**63), 0.5, np.nan, np.inf, -np.inf,
    1e300,
    -1e300, 5e-324,
]  # fmt: skip
DTYPES = [
    "<f8", ">f8", "<i8", ">i8", "<i4", "<u8", "|b1", "<f4", "<f2", "<c16", "<U3", "|S4", "<M8[s]", "<m8[D]", "<i2",
    "|u1", "|V8",
]  # fmt: skip
SHAPES = [
    (), (0,), (1,), (-1,), (10**9,), (10**12,), (2**62,), (2**64,), (3, 10**9), (10**30,), (1.5,), ("x",), None, [3],
    (True,),
    (2, 2), (0, 10**12), (1,) * 65, (10**6, 10**6),
]  # fmt: skip
DESCRIPTIONS = [
    "'|O'", "'<f8'", "'>i8'", "'<i8'", "'<U100'", "'<U1000000000'", "'|V1000000000'", "'nonsense'", "''", "None", "3",
    "[('a', '<f8')]", "[('a', '|O')]", "('<f8', (1000, 1000, 1000))", "'<f8,' * 3", "{}", "[]",
    "'<M8[1000000000000Y]'", "b'<f8'",
]  # fmt: skip


@st.composite
def damaged_bytes(draw: Draw, data: bytes) -> bytes:
    """The bytes after one to three accidents."""
    for _ in range(draw(st.integers(1, 3))):
        i, j = sorted(draw(st.integers(0, len(data))) for _ in range(2))
        j = min(j, i + 300)
        match draw(st.integers(0, 8)):
            case 0:
                data = data[:i]
            case 1:
                data = data[:i] + data[j:]
            case 2:
                data = data[:j] + data[i:]
            case 3:
                data = data[:i] + draw(st.sampled_from(TOKENS)) + data[i:]
            case 4:
                data = data[:i] + draw(st.sampled_from(TOKENS)) + data[j:]
            case 5:
                data = (
                    data[:i] + draw(st.binary(min_size=1, max_size=8)) + data[i + 1 :]
                )
            case 6 if i < len(data):
                data = (
                    data[:i]
                    + bytes([data[i] ^ (1 << draw(st.integers(0, 7)))])
                    + data[i + 1 :]
                )
            case 7:
                data = data[:i] + bytes(j - i) + data[j:]
            case _:
                k = draw(st.integers(0, len(data)))
                data = data[:k] + data[i:j] + data[k:]
    return data


@st.composite
def damaged_rows(draw: Draw, data: bytes) -> bytes:
    """CSV text with a few fields or rows changed, the rest intact."""
    rows = [line.split(b",") for line in data.split(b"\n")]
    for _ in range(draw(st.integers(1, 3))):
        i = draw(st.integers(0, len(rows) - 1))
        match draw(st.integers(0, 5)):
            case 0 if len(rows) > 1:
                del rows[i]
            case 1:
                rows.insert(draw(st.integers(0, len(rows))), rows[i])
            case 2:
                rows[i] = rows[i] + [draw(st.sampled_from(TOKENS))]
            case _:
                number = str(
                    draw(st.sampled_from(NUMBERS) | st.integers(-2, 30))
                ).encode()
                rows[i] = list(rows[i])
                rows[i][draw(st.integers(0, len(rows[i]) - 1))] = draw(
                    st.sampled_from([number, *TOKENS])
                )
    return b"\n".join(b",".join(row) for row in rows)


def _places(tree: Any, levels: int = 50) -> list[tuple[Any, Any]]:
    """Every (container, key) in what JSON made, so many levels deep."""
    if not levels:
        return []
    keys = (
        tree.keys()
        if isinstance(tree, dict)
        else range(len(tree))
        if isinstance(tree, list)
        else ()
    )
    return [
        place
        for key in list(keys)
        for place in [(tree, key), *_places(tree[key], levels - 1)]
    ]


@st.composite
def damaged_json(draw: Draw, text: str | bytes) -> str:
    """JSON text in which up to three values are gone, doubled, under another name or of another type."""
    tree = json.loads(text)
    for _ in range(draw(st.integers(1, 3))):
        if not (places := _places(tree)):
            break
        inside, key = draw(st.sampled_from(range(len(places))).map(places.__getitem__))
        match draw(st.integers(0, 9)):
            case 0:
                del inside[key]
            case 1 if isinstance(inside, dict):
                inside[draw(st.sampled_from(["x", "", "kind", key + " "]))] = (
                    inside.pop(key)
                )
            case 2 if isinstance(inside, list):
                inside.insert(key, inside[key])
            case 3:
                inside[key] = [inside[key]]
            case 4 if type(inside[key]) in (int, float):
                inside[key] = draw(st.integers(-3, 30))
            case _:
                inside[key] = copy.deepcopy(
                    draw(st.sampled_from(JSON_VALUES))
                )  # the next damage may be inside it
    if draw(st.integers(0, 19)) == 0:
        tree = draw(st.sampled_from(JSON_VALUES))
    return json.dumps(tree)


@st.composite
def damaged_array(draw: Draw, array: np.ndarray) -> bytes:
    """A ``.npy`` file whose numbers, type or shape are others, or whose header claims what is not there."""
    match draw(st.integers(0, 7)):
        case 0:
            return npy(
                array.tobytes(), repr(array.dtype.str), draw(st.sampled_from(SHAPES))
            )
        case 1:
            return npy(
                array.tobytes(), draw(st.sampled_from(DESCRIPTIONS)), array.shape
            )
        case 2:
            with np.errstate(all="ignore"):
                try:
                    array = array.astype(draw(st.sampled_from(DTYPES)))
                except (TypeError, ValueError):
                    array = array.ravel()[:0]
        case 3:
            array = draw(
                st.sampled_from(
                    [
                        array[..., None],
                        array[None],
                        array.ravel()[:1],
                        array.ravel()[:0],
                        array.T,
                    ]
                )
            )
        case 4:
            array = draw(
                st.sampled_from(
                    [np.append(array, array), array.ravel()[:-1], array.ravel()[::-1]]
                )
            )
        case _ if array.size and array.dtype.kind in "iufb":
            array = array.astype(draw(st.sampled_from([array.dtype, "f8"])))
            for _ in range(draw(st.integers(1, 3))):
                number = draw(st.sampled_from(NUMBERS))
                array.flat[draw(st.integers(0, array.size - 1))] = _fitting(
                    number, array.dtype
                )
    buffer = io.BytesIO()
    np.save(buffer, array)
    data = buffer.getvalue()
    return draw(damaged_bytes(data)) if draw(st.integers(0, 9)) == 0 else data


def _fitting(number: float, dtype: np.dtype) -> Any:
    """The number as an array of this type can hold it."""
    if dtype.kind in "iu":
        limits = np.iinfo(dtype)
        return int(
            np.clip(
                0 if number != number else number,
                float(limits.min),
                float(limits.max) / 2,
            )
        )
    return number


def npy(
    data: bytes, description: str, shape: object, order: str = "False", version: int = 1
) -> bytes:
    """A ``.npy`` file with this header, whether or not it is true."""
    header = f"{{'descr': {description}, 'fortran_order': {order}, 'shape': {shape!r}, }}\n".encode()
    return (
        b"\x93NUMPY"
        + bytes([version, 0])
        + struct.pack("<H", len(header))
        + header
        + data
    )


@st.composite
def damaged_archive(draw: Draw, data: bytes) -> bytes:
    """A ``.npz`` file with other members, other arrays, another ``about``; or simply other bytes."""
    if draw(st.integers(0, 4)) == 0:
        return draw(damaged_bytes(data))
    with zipfile.ZipFile(io.BytesIO(data)) as file:
        members = {name: file.read(name) for name in file.namelist()}
    arrays = {name: np.load(io.BytesIO(content)) for name, content in members.items()}
    for _ in range(draw(st.integers(1, 2))):
        name = draw(st.sampled_from(sorted(members)))
        array = arrays.get(name, np.zeros(3))
        match draw(st.integers(0, 11)):
            case 0 if len(members) > 1:
                del members[name]
            case 1:
                members[
                    draw(
                        st.sampled_from(
                            ["x.npy", "x", "about.npy", "../x.npy", "q.npy"]
                        )
                    )
                ] = members[name]
            case 2:
                members[name] = members[draw(st.sampled_from(sorted(members)))]
            case 3:
                members[name] = draw(damaged_bytes(members[name]))
            case 4:
                members[name] = b"(" * draw(st.sampled_from([1, 300, 100_000]))
            case _ if array.dtype.kind == "U" and array.ndim == 0:
                buffer = io.BytesIO()
                np.save(buffer, np.array(draw(damaged_json(str(array)))))
                members[name] = buffer.getvalue()
            case _:
                members[name] = draw(damaged_array(array))
    packing = draw(
        st.sampled_from(
            [
                zipfile.ZIP_DEFLATED,
                zipfile.ZIP_DEFLATED,
                zipfile.ZIP_STORED,
                zipfile.ZIP_LZMA,
            ]
        )
    )
    return archive(members, packing)


def archive(members: dict[str, bytes], packing: int = zipfile.ZIP_DEFLATED) -> bytes:
    """A zip file of these members."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", packing) as file:
        for name, content in members.items():
            file.writestr(
                zipfile.ZipInfo(name), content, compress_type=packing
            )  # without today's date
    return buffer.getvalue()


@cache
def bomb(name: str, megabytes: int = 700) -> bytes:
    """An archive of under 1 MB with one array, all zeros, that is as large as this."""
    content = npy(b"", "'|u1'", (megabytes << 20,))
    zeros, crc = bytes(1 << 20), zlib.crc32(content)
    pack = zlib.compressobj(9, zlib.DEFLATED, -15)
    packed = [pack.compress(content), pack.flush(zlib.Z_FULL_FLUSH)]
    packed += [
        pack.compress(zeros) + pack.flush(zlib.Z_FULL_FLUSH)
    ]  # after a full flush, the same bytes again
    first = b"".join(packed[:2])
    for _ in range(megabytes):
        crc = zlib.crc32(zeros, crc)
    body = first + packed[2] * megabytes + pack.flush()
    sizes = struct.pack("<LLL", crc, len(body), len(content) + (megabytes << 20))
    head = (
        struct.pack("<HHHHH", 20, 0, 8, 0, 0x21)
        + sizes
        + struct.pack("<HH", len(name), 0)
    )
    local = b"PK\x03\x04" + head + name.encode()
    central = b"PK\x01\x02" + struct.pack("<H", 20) + head + bytes(14) + name.encode()
    end = struct.pack("<HHHHLLH", 0, 0, 1, 1, len(central), len(local) + len(body), 0)
    return local + body + central + b"PK\x05\x06" + end
