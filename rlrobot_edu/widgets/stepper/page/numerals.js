// Numbers as they stand in tables and equations (numerals.py), and the colours of values (colours.py),
// whose BLUE, VERMILION and ORANGE saved_page.py gives.

const tidy = (text) => text.replace("e+", "e").replaceAll("-", "−");
const withoutZeros = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);

// x with so many digits that count, as Python's %g writes it.
function general(x, digits) {
  const [mantissa, exponent] = x.toExponential(digits - 1).split("e");
  if (exponent < -4 || exponent >= digits) return `${withoutZeros(mantissa)}e${+exponent}`;
  return withoutZeros(x.toFixed(digits - 1 - exponent));
}

const given = (x) => tidy(general(x, 6)); // a number that somebody set: 0.1, 10, −0.02

function number(x) { // 12.35, 0.905, −0.002
  const size = Math.abs(x);
  if (size === 0 || (size >= 1 && size < 100)) return tidy(x.toFixed(2));
  if (size >= 100) return tidy(size < 1e4 ? x.toFixed(1) : x.toExponential(1));
  return tidy(size >= 0.01 ? x.toFixed(3) : general(x, 2));
}

// How to write two numbers so that they are told apart: as above, or with more decimals.
function writerFor(was, now) {
  if (was === now || number(was) !== number(now)) return number;
  let decimals = 4;
  while (decimals < 12 && was.toFixed(decimals) === now.toFixed(decimals)) decimals += 1;
  return (x) => tidy(x.toFixed(decimals));
}

function short(x) { // six signs at most: 12.3, 0.90, −0.021, 4e−5; a plain 0 is exactly 0
  const size = Math.abs(x);
  if (size >= 1e5 || (size > 0 && size < 0.0005)) return tidy(x.toExponential(0));
  return x === 0 ? "0" : tidy(x.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : size >= 0.1 ? 2 : 3));
}

const FAINTEST = 0.18, STRONGEST = 0.68, STRONGEST_TRACE = 0.5; // opacities; black on white and white on black stand out on all of them

// The value of the strongest colour: 1, 2 or 5 times a power of ten, no less than any |Q| and than rMax.
function largest(q, rMax) {
  let most = rMax;
  for (const row of q) for (const x of row) if (Math.abs(x) > most) most = Math.abs(x);
  const power = 10 ** Math.floor(Math.log10(most));
  return [1, 2, 5, 10].map((leap) => power * leap).find((each) => each >= most) ?? most;
}

const css = (colour, opacity) => `${colour}${Math.round(255 * opacity).toString(16).padStart(2, "0")}`;
const tint = (x, most) => { // by its root, so that −0.9 is seen beside 25
  const strength = Math.sqrt(Math.min(Math.abs(x) / most, 1));
  return x === 0 ? `${BLUE}00` : css(x > 0 ? BLUE : VERMILION, FAINTEST + (STRONGEST - FAINTEST) * strength);
};
const traceTint = (e) => css(ORANGE, STRONGEST_TRACE * Math.min(e, 1));
const escaped = (text) => String(text).replace(/[&<>"']/g, (sign) => `&#${sign.charCodeAt(0)};`);
