/**
 * A sentence whose values change many times a second: it is looked up once, with marks in the places of
 * its values, and filled by joining. For values that bend no other word of the sentence; a number that
 * decides between "degree" and "degrees" is looked up by its count.
 */
const BEGIN = "\ue000";
const END = "\ue001";
const MARK = new RegExp(`${BEGIN}(.*?)${END}`, "u");

/**
 * @param names of the values
 * @param say looks the sentence up with the marks as its values
 * @returns fills the sentence; numbers with a decimal sign must be written as the language writes them
 */
export function preparePhrase<Name extends string>(
  names: readonly Name[],
  say: (marks: Readonly<Record<Name, string>>) => string,
): (values: Readonly<Record<Name, string | number>>) => string {
  const marks = Object.fromEntries(names.map((name) => [name, BEGIN + name + END]));
  const parts = say(marks as Record<Name, string>).split(MARK);
  return (values) => parts.map((part, at) => (at % 2 === 0 ? part : values[part as Name])).join("");
}
