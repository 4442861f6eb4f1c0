/** Parts of the regular expressions that read the sentences of a diagnosis. */

export const who = "(?<who>[Ll]ine \\d+|“otherwise”)";
export const inner = "(?<inner>line \\d+|“otherwise”)";
export const action = "“(?<action>[a-z 0-9]+)”";
export const at = "at (?<at>[\\d.]+) s";
export const sensor = "(?<sensor>front|back|left|right)";
/**
 * Sensors for a distance along the path. Driving on brings the robot no nearer to what is beside
 * it.
 */
export const along = "(?<sensor>front|back)";
export const number = "\\d+(?:\\.\\d+)?";
export const reading = `(?<reading>${number}) cm`;
export const read = `\\((?:${sensor}: ${reading}|left: (?<left>${number}) cm, right: (?<right>${number}) cm)\\)`;
export const sides = `\\(front: (?<front>${number}) cm, left: (?<left>${number}) cm, right: (?<right>${number}) cm\\)`;
