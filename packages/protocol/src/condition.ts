/**
 * Conditions on the robot's state: the `when` of a program's rule, and the `until` of a guarded
 * motion. Both have the same shape and bounds. A guarded motion has two more comparators, and can
 * end in a goal.
 */
import { z } from "zod";
import { MAX_CONDITIONS, MAX_PLUS, MAX_THAN } from "./condition-bounds.ts";
import { sensorNames, type SensorName } from "./sensor-names.ts";

const untilComparators = [">", "<", ">=", "<="] as const;
type UntilComparator = (typeof untilComparators)[number];

const than = z
  .number({ error: `a number from 0 to ${MAX_THAN}` })
  .min(0, { error: `a number from 0 to ${MAX_THAN}` })
  .max(MAX_THAN, { error: `a number from 0 to ${MAX_THAN}` });

const plus = z
  .number({ error: `a number from ${-MAX_PLUS} to ${MAX_PLUS}` })
  .min(-MAX_PLUS, { error: `a number from ${-MAX_PLUS} to ${MAX_PLUS}` })
  .max(MAX_PLUS, { error: `a number from ${-MAX_PLUS} to ${MAX_PLUS}` });

/** The two shapes of a comparison with these comparators. */
function comparisons<const C extends readonly [string, ...string[]]>(
  comparators: C,
  error: string,
) {
  const list = comparators.map((each) => `"${each}"`).join(", ");
  const comparator = z.enum(comparators, { error: `one of ${list}` });
  const againstNumber = z.strictObject(
    {
      sensor: z.enum(sensorNames, { error: `one of ${sensorNames.join(", ")}` }),
      is: comparator,
      than,
    },
    { error },
  );
  const againstRight = z.strictObject({
    sensor: z.literal("left", { error: '"left", when it is compared with "right"' }),
    is: comparator,
    than: z.literal("right"),
    plus,
  });
  return { againstNumber, againstRight };
}

/** Reads a value by one schema. Its problems name the field, unlike those of z.union. */
function readBy<T>(schema: z.ZodType<T>, input: unknown, context: z.RefinementCtx): T {
  const result = schema.safeParse(input);
  if (result.success) return result.data;
  for (const issue of result.error.issues) {
    const fields = issue.code === "unrecognized_keys" ? issue.keys : [undefined];
    for (const field of fields) {
      context.issues.push({
        code: "custom",
        input,
        path: field === undefined ? issue.path : [...issue.path, field],
        message: field === undefined ? issue.message : "no field of this name",
      });
    }
  }
  return z.NEVER;
}

function isAgainstRight(input: unknown): boolean {
  return typeof input === "object" && input !== null && "than" in input && input.than === "right";
}

function isGoal(input: unknown): boolean {
  return typeof input === "object" && input !== null && "goal" in input;
}

const rule = comparisons(
  [">", "<"],
  'a condition: {"sensor": ..., "is": ..., "than": ...} or null',
);

/** Compares a sensor with a number, or left with right plus a number. */
export type RuleCondition = z.infer<typeof rule.againstNumber> | z.infer<typeof rule.againstRight>;

export const ruleConditionSchema = z
  .unknown()
  .transform((input, context): RuleCondition =>
    isAgainstRight(input)
      ? readBy(rule.againstRight, input, context)
      : readBy(rule.againstNumber, input, context),
  )
  // The output schema lets generators of API descriptions read the shape.
  .pipe(z.union([rule.againstNumber, rule.againstRight]));

const until = comparisons(
  untilComparators,
  'a condition: {"sensor": ..., "is": ..., "than": ...} or {"goal": true}',
);
const goal = z.strictObject({ goal: z.literal(true, { error: "true" }) });

/** One condition of a guarded motion: a comparison, or that the robot stands in a goal cell. */
export type UntilCondition =
  /** a reading (front, right, back, left), compared (>, <, >=, <=) with a number in cm */
  | { sensor: SensorName; is: UntilComparator; than: number }
  /** the left reading, compared with the right reading plus a number in cm */
  | { sensor: "left"; is: UntilComparator; than: "right"; plus: number }
  /** whether the whole robot stands in a goal cell */
  | { goal: true };

export const untilConditionSchema = z
  .unknown()
  .transform((input, context): UntilCondition => {
    if (isGoal(input)) return readBy(goal, input, context);
    return isAgainstRight(input)
      ? readBy(until.againstRight, input, context)
      : readBy(until.againstNumber, input, context);
  })
  .pipe(z.union([until.againstNumber, until.againstRight, goal]));

const untilError = `a list of 1 to ${MAX_CONDITIONS} conditions`;

/** The conditions of a guarded motion. It ends on the first tick on which one of them is true. */
export const untilSchema = z
  .array(untilConditionSchema, { error: untilError })
  .min(1, { error: untilError })
  .max(MAX_CONDITIONS, { error: untilError });
