/** Settings of the relay, read from the environment and validated once at startup. */
import {
  describeProblem,
  readValue,
  type FieldProblem,
  gatewayNames,
  type GatewayName,
} from "@corridor/protocol";
import { z } from "zod";
import { misspeltSettings } from "./platform/process/misspelt-settings.ts";
import { readNetwork, type TrustedProxies } from "./platform/http/trusted-proxies.ts";

const DEFAULT_PORT = 8080;
const portError = "a port number from 0 to 65535 (0: any free port)";
const urlError = "an address without a path, such as https://robots.example.org";
const hostsError = "host names with commas between them, such as robots.example.org, localhost";
const embedError =
  "addresses without a path, with commas between them, such as https://moodle.example.org";
const proxiesError =
  "the number of proxies in front, from 0 to 9, or their addresses and networks, such as 127.0.0.1, 10.0.0.0/8";
const storeError = "the address of a Redis or Valkey, such as redis://127.0.0.1:6379";
const drainError = "whole seconds from 0 to 60";
const gatewaysError = `${gatewayNames.join(", ")} with commas between them, or none`;
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

function splitList(text: string): string[] {
  return text.split(",").map((word) => word.trim());
}

function isGateway(name: string): name is GatewayName {
  return (gatewayNames as readonly string[]).includes(name);
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
  /** address to listen on; if unset, all addresses, so that a class can connect */
  HOST: host.optional(),
  DATA_DIR: z.string().min(1, { error: "a folder" }).default("data"),
  /** if unset, SQLite in DATA_DIR */
  STORE_URL: z.string().refine(isRedisUrl, { error: storeError }).optional(),
  PUBLIC_URL: z
    .string()
    .refine(isOrigin, { error: urlError })
    .transform((url) => new URL(url).origin)
    .optional(),
  /** host names of this service; requests for other hosts are rejected */
  ALLOWED_HOSTS: z
    .string()
    .transform((text) => splitList(text.toLowerCase()))
    .refine((names) => names.every(isHostName), { error: hostsError })
    .optional(),
  /** sites that may show `/embed` in a frame */
  EMBED_ORIGINS: z
    .string()
    .transform(splitList)
    .refine((origins) => origins.every(isOrigin), { error: embedError })
    .transform((origins) => origins.map((each) => new URL(each).origin))
    .optional(),
  /** protocols by which scripts drive a robot, besides the API */
  GATEWAYS: z
    .string()
    .transform((text) => (text.trim() === "none" ? [] : splitList(text)))
    .refine((names): names is GatewayName[] => names.every(isGateway), { error: gatewaysError })
    .default([...gatewayNames]),
  /** proxies whose X-Forwarded-* headers are trusted */
  TRUSTED_PROXIES: z
    .string()
    .transform((text): TrustedProxies => (/^\d$/.test(text) ? Number(text) : splitList(text)))
    .refine(
      (proxies) =>
        typeof proxies === "number" || proxies.every((proxy) => readNetwork(proxy) !== null),
      { error: proxiesError },
    )
    .default(0),
  /** if unset, metrics are disabled */
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
  /** null: all addresses */
  host: string | null;
  /** folder of the SQLite database */
  dataDir: string;
  /** URL of the Redis or Valkey that stores all data; null: SQLite in `dataDir` */
  storeUrl: string | null;
  /** origin of the service as clients see it; null: taken from each request */
  publicOrigin: string | null;
  /** null: any host name */
  allowedHosts: readonly string[] | null;
  /** origins whose pages may show `/embed` in a frame; null: any page */
  embedOrigins: readonly string[] | null;
  /** protocols by which scripts drive a robot, besides the API */
  gateways: readonly GatewayName[];
  trustedProxies: TrustedProxies;
  /** port of /metrics; null: disabled */
  metricsPort: number | null;
  /** address to serve /metrics on */
  metricsHost: string;
  /** seconds between "not ready" and shutdown on SIGTERM */
  drainSeconds: number;
  logLevel: (typeof LOG_LEVELS)[number];
}

/** Settings that may hold a password. Error messages never print their values. */
const secretNames: ReadonlySet<string> = new Set(["STORE_URL"]);

function withoutSecrets(problem: FieldProblem): FieldProblem {
  return secretNames.has(problem.path)
    ? { ...problem, found: "another value (hidden because it may contain a password)" }
    : problem;
}

/**
 * Reads and validates the settings.
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
      embedOrigins: value.EMBED_ORIGINS ?? null,
      gateways: value.GATEWAYS,
      trustedProxies: value.TRUSTED_PROXIES,
      metricsPort: value.METRICS_PORT ?? null,
      metricsHost: value.METRICS_HOST,
      drainSeconds: value.DRAIN_SECONDS,
      logLevel: value.LOG_LEVEL,
    },
  };
}

/** Formats the problems as text for the operator. */
export function describeConfigProblems(problems: readonly FieldProblem[]): string {
  const lines = problems.map((each) => `  ${describeProblem(each)}`);
  return ["Corridor cannot start: invalid settings in the environment.", ...lines].join("\n");
}

/** Hosts that a browser on this machine reaches as localhost. */
const LOCAL_HOSTS = new Set(["0.0.0.0", "::", "127.0.0.1", "::1", "localhost"]);

/** Address to open in a browser. @param port the actual port */
export function addressToOpen({ host, publicOrigin }: Config, port: number): string {
  if (publicOrigin !== null) return publicOrigin;
  if (host === null || LOCAL_HOSTS.has(host)) return `http://localhost:${port}`;
  return `http://${host.includes(":") ? `[${host}]` : host}:${port}`;
}
