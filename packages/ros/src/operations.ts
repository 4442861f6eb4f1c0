/** The operations of a client, as rosbridge v2 defines them. Fields that have no effect are ignored. */
import { MAX_FRAME_BYTES, parseJson } from "@corridor/protocol";
import { z } from "zod";

const MAX_NAME = 256;

const name = z.string().min(1).max(MAX_NAME);
const type = z.string().max(MAX_NAME);
/** Replies repeat it unchanged. */
const id = z.union([z.string().max(MAX_NAME), z.int(), z.null()]).optional();
/** ms; clients send 0 for no limit */
const throttleRate = z.number().min(0).max(3_600_000).nullish();

const operations = {
  advertise: z.object({ topic: name, type }),
  unadvertise: z.object({ topic: name }),
  publish: z.object({ topic: name, msg: z.unknown() }),
  subscribe: z.object({
    topic: name,
    id,
    type: type.nullish(),
    throttle_rate: throttleRate,
    compression: z.string().nullish(),
  }),
  unsubscribe: z.object({ topic: name, id }),
  call_service: z.object({ service: name, id, args: z.unknown().optional(), type: type.nullish() }),
  send_action_goal: z.object({
    action: name,
    action_type: type.nullish(),
    id,
    args: z.unknown().optional(),
    feedback: z.boolean().nullish(),
  }),
  cancel_action_goal: z.object({ action: name, id }),
  set_level: z.object({ level: z.enum(["info", "warning", "error", "none"]) }),
  auth: z.object({}),
};

const envelope = z.object({ op: name, id });

type Operations = typeof operations;
export type OperationName = keyof Operations;
export type Fields<N extends OperationName> = z.infer<Operations[N]>;
export type ReplyId = z.infer<typeof id>;
export type Operation = { [N in OperationName]: { op: N } & Fields<N> }[OperationName];

export type ReadOperation =
  | { ok: true; operation: Operation }
  /** isReadable: an operation that Corridor does not support */
  | { ok: false; isReadable: boolean; detail: string };

const NOT_READABLE =
  "A message is not an operation of rosbridge: one JSON object with the field 'op', of at most 16 KiB.";

export function readOperation(text: string): ReadOperation {
  const parsed = parseJson(text, MAX_FRAME_BYTES);
  const message = parsed.ok ? envelope.safeParse(parsed.value) : null;
  if (!parsed.ok || message?.success !== true) {
    return { ok: false, isReadable: false, detail: NOT_READABLE };
  }
  const { op } = message.data;
  if (!isOperation(op)) {
    const detail = `This service does not support the operation '${op.slice(0, 40)}'.`;
    return { ok: false, isReadable: true, detail };
  }
  const fields = operations[op].safeParse(parsed.value);
  if (fields.success) return { ok: true, operation: { op, ...fields.data } as Operation };
  const path = fields.error.issues[0]?.path.join(".") ?? "";
  const detail = `An operation '${op}' has no valid field '${path}'.`;
  return { ok: false, isReadable: false, detail };
}

function isOperation(op: string): op is OperationName {
  return Object.hasOwn(operations, op);
}

const authSchema = z.object({ op: z.literal("auth"), mac: z.string().max(MAX_NAME) });

/** @returns the key in an operation `auth`; null if the message is another one */
export function keyInAuth(text: string): string | null {
  const parsed = parseJson(text, MAX_FRAME_BYTES);
  const auth = parsed.ok ? authSchema.safeParse(parsed.value) : null;
  return auth?.success === true ? auth.data.mac : null;
}
