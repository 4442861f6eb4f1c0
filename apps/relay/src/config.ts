/** Settings of the relay: the environment, checked once at the start. Every problem is named. */
import { describeProblem, readValue, type FieldProblem } from "@corridor/protocol";
import { z } from "zod";

const DEFAULT_PORT = 8080;
const portError = "a port number from 0 to 65535 (0: any free port)";
const urlError = "an address without a path, such as https://robots.example.org";
const LOG_LEVELS = ["fatal", "error", "warn", "info", "debug", "silent"] as const;

function isOrigin(text: string): boolean {
  if (!URL.canParse(text)) return false;
  const { origin, protocol, href } = new URL(text);
  return /^https?:$/.test(protocol) && href === `${origin}/`;
}

const environmentSchema = z.object({
  PORT: z
    .string()
    .regex(/^\d{1,5}$/, { error: portError })
    .transform(Number)
    .refine((port) => port <= 65_535, { error: portError })
    .default(DEFAULT_PORT),
  /** address to listen on; unset: every address of this machine, so that a class can join */
  HOST: z.string().min(1, { error: "an address of this machine, such as 127.0.0.1" }).optional(),
  DATA_DIR: z.string().min(1, { error: "a folder" }).default("data"),
  PUBLIC_URL: z
    .string()
    .refine(isOrigin, { error: urlError })
    .transform((url) => new URL(url).origin)
    .optional(),
  LOG_LEVEL: z.enum(LOG_LEVELS, { error: `one of ${LOG_LEVELS.join(", ")}` }).default("warn"),
});

export interface Config {
  port: number;
  /** null: every address */
  host: string | null;
  /** folder of the database */
  dataDir: string;
  /** origin under which the service is reached from outside; null: what each request says */
  publicOrigin: string | null;
  logLevel: (typeof LOG_LEVELS)[number];
}

/**
 * Reads the settings.
 * @param environment such as process.env; an empty value counts as unset
 */
export function readConfig(
  environment: Record<string, string | undefined>,
): { ok: true; config: Config } | { ok: false; problems: FieldProblem[] } {
  const given = Object.fromEntries(
    Object.entries(environment).filter(([, value]) => value !== undefined && value !== ""),
  );
  const result = readValue(environmentSchema, given);
  if (!result.ok) return result;
  const { PORT, HOST, DATA_DIR, PUBLIC_URL, LOG_LEVEL } = result.value;
  return {
    ok: true,
    config: {
      port: PORT,
      host: HOST ?? null,
      dataDir: DATA_DIR,
      publicOrigin: PUBLIC_URL ?? null,
      logLevel: LOG_LEVEL,
    },
  };
}

/** The problems as sentences for whoever started the relay. */
export function describeConfigProblems(problems: readonly FieldProblem[]): string {
  const lines = problems.map((each) => `  ${describeProblem(each)}`);
  return ["Corridor cannot start: a setting in the environment is wrong.", ...lines].join("\n");
}

/** Addresses that mean "this machine", for whoever sits at it. */
const HERE = new Set(["0.0.0.0", "::", "127.0.0.1", "::1", "localhost"]);

/** The address to open in a browser. @param port the one that is really listened on */
export function addressToOpen({ host, publicOrigin }: Config, port: number): string {
  if (publicOrigin !== null) return publicOrigin;
  if (host === null || HERE.has(host)) return `http://localhost:${port}`;
  return `http://${host.includes(":") ? `[${host}]` : host}:${port}`;
}
