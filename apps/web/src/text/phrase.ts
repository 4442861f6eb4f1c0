/**
 * A sentence whose values change many times a second. The catalogue is read once, with markers in place
 * of the values, which are then replaced. Only for values that change no other word of the sentence: a
 * number that decides between "degree" and "degrees" needs a lookup by its count.
 */
const BEGIN = "\ue000";
const END = "\ue001";
const MARK = new RegExp(`${BEGIN}(.*?)${END}`, "u");

/**
 * @param names of the values
 * @param translate looks up the sentence with the given values
 * @returns a function that inserts values; format numbers with decimals for the language first
 */
export function preparePhrase<Name extends string>(
  names: readonly Name[],
  translate: (marks: Readonly<Record<Name, string>>) => string,
): (values: Readonly<Record<Name, string | number>>) => string {
  const marks = Object.fromEntries(names.map((name) => [name, BEGIN + name + END]));
  const parts = translate(marks as Record<Name, string>).split(MARK);
  return (values) => parts.map((part, at) => (at % 2 === 0 ? part : values[part as Name])).join("");
}
