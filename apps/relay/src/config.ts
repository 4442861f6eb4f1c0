/** Settings of the relay: the environment, checked once at the start. Every problem is named. */
import { describeProblem, readValue, type FieldProblem } from "@corridor/protocol";
import { z } from "zod";
import { misspeltSettings } from "./misspelt-settings.ts";
import { readNetwork, type TrustedProxies } from "./entrance/trusted-proxies.ts";

const DEFAULT_PORT = 8080;
const portError = "a port number from 0 to 65535 (0: any free port)";
const urlError = "an address without a path, such as https://robots.example.org";
const hostsError = "host names with commas between them, such as robots.example.org, localhost";
const proxiesError =
  "the number of proxies in front, from 0 to 9, or their addresses and networks, such as 127.0.0.1, 10.0.0.0/8";
const storeError = "the address of a Redis or Valkey, such as redis://127.0.0.1:6379";
const drainError = "whole seconds from 0 to 60";
const LOG_LEVELS = ["fatal", "error", "warn", "info", "debug", "silent"] as const;

function isOrigin(text: string): boolean {
  if (!URL.canParse(text)) return false;
  const { origin, protocol, href } = new URL(text);
  return /^https?:$/.test(protocol) && href === `${origin}/`;
}

function isRedisUrl(text: string): boolean {
  if (!URL.canParse(text)) return false;
  const { protocol, hostname } = new URL(text);
  return /^rediss?:$/.test(protocol) && hostname !== "";
}

function words(text: string): string[] {
  return text.split(",").map((word) => word.trim());
}

function isHostName(text: string): boolean {
  if (!/^[\w.:[\]-]+$/.test(text) || !URL.canParse(`http://${text}`)) return false;
  return new URL(`http://${text}`).hostname === text;
}

const port = z
  .string()
  .regex(/^\d{1,5}$/, { error: portError })
  .transform(Number)
  .refine((number) => number <= 65_535, { error: portError });
const host = z.string().min(1, { error: "an address of this machine, such as 127.0.0.1" });

const environmentSchema = z.object({
  PORT: port.default(DEFAULT_PORT),
  /** address to listen on; unset: every address of this machine, so that a class can join */
  HOST: host.optional(),
  DATA_DIR: z.string().min(1, { error: "a folder" }).default("data"),
  /** unset: SQLite in DATA_DIR */
  STORE_URL: z.string().refine(isRedisUrl, { error: storeError }).optional(),
  PUBLIC_URL: z
    .string()
    .refine(isOrigin, { error: urlError })
    .transform((url) => new URL(url).origin)
    .optional(),
  /** the names of this service; a request for another is refused */
  ALLOWED_HOSTS: z
    .string()
    .transform((text) => words(text.toLowerCase()))
    .refine((names) => names.every(isHostName), { error: hostsError })
    .optional(),
  /** whose X-Forwarded-* headers count */
  TRUSTED_PROXIES: z
    .string()
    .transform((text): TrustedProxies => (/^\d$/.test(text) ? Number(text) : words(text)))
    .refine(
      (proxies) =>
        typeof proxies === "number" || proxies.every((proxy) => readNetwork(proxy) !== null),
      { error: proxiesError },
    )
    .default(0),
  /** unset: no figures */
  METRICS_PORT: port.optional(),
  METRICS_HOST: host.default("127.0.0.1"),
  DRAIN_SECONDS: z
    .string()
    .regex(/^([0-9]|[1-5][0-9]|60)$/, { error: drainError })
    .transform(Number)
    .default(0),
  LOG_LEVEL: z.enum(LOG_LEVELS, { error: `one of ${LOG_LEVELS.join(", ")}` }).default("warn"),
});

export interface Config {
  port: number;
  /** null: every address */
  host: string | null;
  /** folder of the database */
  dataDir: string;
  /** Redis or Valkey that the relay keeps everything in; null: the database in `dataDir` */
  storeUrl: string | null;
  /** origin under which the service is reached from outside; null: what each request says */
  publicOrigin: string | null;
  /** null: any name will do */
  allowedHosts: readonly string[] | null;
  trustedProxies: TrustedProxies;
  /** port of /metrics; null: there is none */
  metricsPort: number | null;
  /** address that /metrics is served on */
  metricsHost: string;
  /** seconds between "not ready" and the end, on SIGTERM */
  drainSeconds: number;
  logLevel: (typeof LOG_LEVELS)[number];
}

/** Settings that hold a password, which no log may show, even where it stands in the wrong place. */
const secretNames: ReadonlySet<string> = new Set(["STORE_URL"]);

function withoutSecrets(problem: FieldProblem): FieldProblem {
  return secretNames.has(problem.path)
    ? { ...problem, found: "something else (not shown: it may hold a password)" }
    : problem;
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
  const problems = [
    ...(result.ok ? [] : result.problems.map(withoutSecrets)),
    ...misspeltSettings(Object.keys(environmentSchema.shape), Object.keys(given)),
  ];
  if (!result.ok || problems.length > 0) return { ok: false, problems };
  const { value } = result;
  return {
    ok: true,
    config: {
      port: value.PORT,
      host: value.HOST ?? null,
      dataDir: value.DATA_DIR,
      storeUrl: value.STORE_URL ?? null,
      publicOrigin: value.PUBLIC_URL ?? null,
      allowedHosts: value.ALLOWED_HOSTS ?? null,
      trustedProxies: value.TRUSTED_PROXIES,
      metricsPort: value.METRICS_PORT ?? null,
      metricsHost: value.METRICS_HOST,
      drainSeconds: value.DRAIN_SECONDS,
      logLevel: value.LOG_LEVEL,
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
