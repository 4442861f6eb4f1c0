import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { readMotion, type ServoMotion } from "./read-motion.ts";
import { VipleError } from "./viple-error.ts";

const servos = (...list: unknown[]): string => JSON.stringify({ servos: list });

function readOrRefuse(text: string): ServoMotion | string | null {
  try {
    return readMotion(text);
  } catch (error) {
    if (error instanceof VipleError) return error.message;
    throw error;
  }
}

describe("the motion of a message", () => {
  it.each<{ name: string; text: string; motion: ServoMotion | null }>([
    {
      name: "servos 3 and 5 are the left and the right wheel",
      text: servos({ servoId: 3, servoSpeed: 0.5 }, { servoId: 5, servoSpeed: -0.5 }),
      motion: { left: 0.5, right: -0.5 },
    },
    {
      name: "one servo leaves the other wheel as it is",
      text: servos({ servoId: 5, servoSpeed: 1 }),
      motion: { right: 1 },
    },
    {
      name: "servo -1 is the whole robot",
      text: servos({ servoId: -1, servoSpeed: 0.25 }),
      motion: { left: 0.25, right: 0.25 },
    },
    {
      name: "so is a servo without a number",
      text: servos({ servoSpeed: -1 }),
      motion: { left: -1, right: -1 },
    },
    {
      name: "isTurn is an angle",
      text: servos({ servoId: 3, servoSpeed: -90, isTurn: true }),
      motion: { degrees: -90 },
    },
    {
      name: "without a turn, the whole robot has only a direction",
      text: servos({ servoSpeed: 90, isTurn: false }),
      motion: { left: 1, right: 1 },
    },
    {
      name: "wheels have their speed, turn or not",
      text: servos({ servoId: 3, servoSpeed: 0.1, isTurn: false }),
      motion: { left: 0.1 },
    },
    {
      name: "the last servo counts",
      text: servos({ servoSpeed: 1 }, { servoSpeed: 90, isTurn: true }, { servoSpeed: 0 }),
      motion: { left: 0, right: 0 },
    },
    {
      name: "other servos and fields are ignored",
      text: '{"a":[[]],"servos":[{"servoId":7,"servoSpeed":900,"b":null}]}',
      motion: null,
    },
    { name: "a message without servos moves nothing", text: '{"sensors":[]}', motion: null },
    { name: "nor does an empty list", text: servos(), motion: null },
  ])("$name", ({ text, motion }) => {
    expect(readMotion(text)).toEqual(motion);
  });

  it.each([
    ["servos", "{", "not one JSON object"],
    ["[]", "[]", "not one JSON object"],
    ["two objects", "{}{}", "not one JSON object"],
    ["NaN", '{"servos":[{"servoSpeed":NaN}]}', "not one JSON object"],
    ["16 KiB and more", `{"a":"${"x".repeat(16 * 1024)}"}`, "not one JSON object"],
    ["no list", '{"servos":{}}', "servos an object, expected a list"],
    ["no object", servos(null), "servos[0] null, expected an object"],
    ["a speed as text", servos({ servoSpeed: "1" }), '[0].servoSpeed "1", expected a number'],
    ["no speed", servos({ servoId: 3 }), "[0].servoSpeed nothing, expected a number"],
    ["an infinite speed", '{"servos":[{"servoSpeed":1e999}]}', "Infinity, expected a number"],
    ["a number as text", servos({ servoId: "3", servoSpeed: 1 }), 'servoId "3", expected a number'],
    ["a turn as text", servos({ servoSpeed: 1, isTurn: "yes" }), "expected true or false"],
    ["too much speed", servos({ servoId: 3, servoSpeed: 1.5 }), "expected a number from -1 to 1"],
    ["a long turn", servos({ servoSpeed: 3601, isTurn: true }), "from -3600 to 3600"],
  ])("refuses %s with a sentence", (_name, text, sentence) => {
    expect(readOrRefuse(text)).toContain(sentence);
  });

  it("is within its bounds or refused with one line, whatever arrives", () => {
    const value = fc.oneof(
      fc.jsonValue(),
      fc.double(),
      fc.constantFrom(-1, 3, 5, true, false, "__proto__"),
    );
    const servo = fc.record(
      { servoId: value, servoSpeed: value, isTurn: value },
      { requiredKeys: [] },
    );
    const message = fc.oneof(
      fc.array(fc.oneof(servo, value)).map((list) => JSON.stringify({ servos: list })),
      fc.json(),
      fc.string({ unit: "binary" }),
    );
    const isAllowed = (read: ServoMotion | string | null): boolean =>
      typeof read === "string"
        ? /^A message of VIPLE .{1,200}\.$/.test(read)
        : Object.entries(read ?? {}).every(
            ([name, number]) => Math.abs(number) <= (name === "degrees" ? 3600 : 1),
          );
    fc.assert(
      fc.property(message, (text) => {
        expect(readOrRefuse(text)).toSatisfy(isAllowed);
      }),
    );
  });
});
