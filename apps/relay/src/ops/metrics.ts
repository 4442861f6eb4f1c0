/**
 * Prometheus metrics of the relay. Label values come from a small fixed set and never contain an
 * id, key, name or address.
 */
import { closeReasons, type CommandRecord, type GatewayName } from "@corridor/protocol";
import { collectDefaultMetrics, Counter, Gauge, Histogram, Registry } from "prom-client";
import type { ProblemKind } from "../platform/errors/problem-kinds.ts";
import type { ClassCounts } from "../classes/registry.ts";
import type { ConnectionCounts } from "../robots/registry.ts";
import type { CommandObserver } from "../robots/delivery/command-observer.ts";

/**
 * Close codes with a time series of their own. Clients may close with any of thousands of codes.
 */
const KNOWN_CODES = new Set<number>([
  1000,
  1001,
  1005,
  1006,
  1009,
  ...Object.values(closeReasons).map(({ code }) => code),
]);

const SECONDS = [0.001, 0.002, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10];

export class Metrics implements CommandObserver {
  readonly #registry = new Registry();
  readonly #pages = new Gauge({
    name: "corridor_robots_with_page",
    help: "Robots whose page is connected.",
    registers: [this.#registry],
  });
  readonly #readers = new Gauge({
    name: "corridor_readers",
    help: "Scripts that read a robot, by transport.",
    labelNames: ["transport"] as const,
    registers: [this.#registry],
  });
  readonly #classes = new Gauge({
    name: "corridor_classes",
    help: "Classes with a connection.",
    registers: [this.#registry],
  });
  readonly #members = new Gauge({
    name: "corridor_class_members",
    help: "Connections to classes, by role.",
    labelNames: ["role"] as const,
    registers: [this.#registry],
  });
  readonly #ended = new Counter({
    name: "corridor_commands_ended_total",
    help: "Commands by the state in which they ended.",
    labelNames: ["state"] as const,
    registers: [this.#registry],
  });
  readonly #refusals = new Counter({
    name: "corridor_refusals_total",
    help: "Rejected requests and messages, by kind of problem.",
    labelNames: ["problem"] as const,
    registers: [this.#registry],
  });
  readonly #gatewayMessages = new Counter({
    name: "corridor_gateway_messages_total",
    help: "Messages and requests of other protocols, by gateway.",
    labelNames: ["gateway"] as const,
    registers: [this.#registry],
  });
  readonly #closed = new Counter({
    name: "corridor_sockets_closed_total",
    help: "WebSockets that were closed, by close code.",
    labelNames: ["code"] as const,
    registers: [this.#registry],
  });
  readonly #stored = this.#seconds(
    "corridor_post_to_stored",
    "From a command's arrival to its commit.",
  );
  readonly #started = this.#seconds(
    "corridor_post_to_started",
    "From a command's arrival to its start.",
  );
  readonly #commits = this.#seconds(
    "corridor_store_commit",
    "Steps of the store that end in a commit.",
  );

  #readGauges: (() => Promise<[ConnectionCounts, ClassCounts]>) | null = null;

  stored(seconds: number): void {
    this.#stored.observe(seconds);
  }

  started(seconds: number): void {
    this.#started.observe(seconds);
  }

  ended(state: CommandRecord["state"]): void {
    this.#ended.inc({ state });
  }

  committed(seconds: number): void {
    this.#commits.observe(seconds);
  }

  refused(problem: ProblemKind): void {
    this.#refusals.inc({ problem });
  }

  /** A message or a request of another protocol, whether it is accepted or not. */
  gatewayMessage(gateway: GatewayName): void {
    this.#gatewayMessages.inc({ gateway });
  }

  socketClosed(code: number): void {
    this.#closed.inc({ code: KNOWN_CODES.has(code) ? String(code) : "other" });
  }

  /** Enables the metrics with a cost of their own: process metrics and gauges of connections. */
  observeGauges(readGauges: () => Promise<[ConnectionCounts, ClassCounts]>): void {
    collectDefaultMetrics({ register: this.#registry });
    this.#readGauges = readGauges;
  }

  /** All metrics in the text format of Prometheus. */
  async report(): Promise<{ type: string; text: string }> {
    const counts = await this.#readGauges?.();
    if (counts !== undefined) {
      const [robots, classes] = counts;
      this.#pages.set(robots.pages);
      for (const [transport, number] of Object.entries(robots.readers)) {
        this.#readers.set({ transport }, number);
      }
      this.#classes.set(classes.classes);
      for (const [role, number] of Object.entries(classes.members)) {
        this.#members.set({ role }, number);
      }
    }
    return { type: this.#registry.contentType, text: await this.#registry.metrics() };
  }

  #seconds(name: string, help: string): Histogram {
    return new Histogram({
      name: `${name}_seconds`,
      help,
      buckets: SECONDS,
      registers: [this.#registry],
    });
  }
}
