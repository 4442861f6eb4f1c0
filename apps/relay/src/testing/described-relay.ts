/** A client of a relay that uses only its `/openapi.json`. */
import { problemSchema, registrationSchema, type Registration } from "@corridor/protocol";
import { z } from "zod";
import type { oas31 } from "zod-openapi";
import { startTestRelay, type AskOptions, type TestRelay } from "./test-relay.ts";

export const METHODS = ["get", "post", "put", "patch", "delete"] as const;
export type Method = (typeof METHODS)[number];

/** All operations of a document, with their path and all of their parameters. */
export function describedCalls(document: oas31.OpenAPIObject) {
  return Object.entries(document.paths ?? {}).flatMap(([path, item]) =>
    METHODS.flatMap((method) => {
      const operation = item[method];
      if (operation === undefined) return [];
      const all = [...(item.parameters ?? []), ...(operation.parameters ?? [])];
      const parameters = all as oas31.ParameterObject[];
      return [{ name: `${method} ${path}`, method, path, operation, parameters }];
    }),
  );
}

export class DescribedRelay {
  readonly relay: TestRelay;
  readonly document: oas31.OpenAPIObject;
  readonly robot: Registration;

  private constructor(relay: TestRelay, document: oas31.OpenAPIObject, robot: Registration) {
    this.relay = relay;
    this.document = document;
    this.robot = robot;
  }

  /** Starts a relay, reads its description and registers a robot through it. */
  static async start(): Promise<DescribedRelay> {
    const relay = await startTestRelay();
    const described = await fetch(`${relay.origin}/openapi.json`);
    const document = (await described.json()) as oas31.OpenAPIObject;
    const path = "/api/v1/robots";
    const answer = await fetch(relay.origin + path, { method: "POST" });
    const body: unknown = await answer.clone().json();
    const api = new DescribedRelay(relay, document, registrationSchema.parse(body));
    await api.#check(`post ${path}`, api.answerOf("post", path, answer.status), answer);
    return api;
  }

  /**
   * Sends a request below /api/v1/robots and checks status, headers and body.
   * @returns status and body
   * @throws Error if the response differs from the description
   */
  async call(
    method: Method,
    path: string,
    { seq, query = "", ...ask }: { seq?: number; query?: string } & AskOptions = {},
  ): Promise<{ status: number; body: unknown }> {
    const below = path.replace("/api/v1/robots/{id}", "").replace("{seq}", String(seq));
    const request = { method: method.toUpperCase(), ...ask };
    const answer = await this.relay.ask(this.robot, below + query, request);
    const described = this.answerOf(method, path, answer.status);
    const body = await this.#check(`${method} ${path}`, described, answer);
    return { status: answer.status, body };
  }

  /**
   * Sends a request to any other path and checks it in the same way.
   * @throws Error if the response differs from the description
   */
  async callAt(
    method: Method,
    path: string,
    { id = "", key, body }: { id?: string; key?: string; body?: unknown } = {},
  ): Promise<{ status: number; body: unknown }> {
    const answer = await fetch(this.relay.origin + path.replace("{id}", id), {
      method: method.toUpperCase(),
      headers: {
        ...(key !== undefined && { Authorization: `Bearer ${key}` }),
        ...(body !== undefined && { "Content-Type": "application/json" }),
      },
      ...(body !== undefined && { body: JSON.stringify(body) }),
    });
    const described = this.answerOf(method, path, answer.status);
    return {
      status: answer.status,
      body: await this.#check(`${method} ${path}`, described, answer),
    };
  }

  /** The described response for a status. @throws Error if there is none */
  answerOf(method: Method, path: string, status: number): oas31.ResponseObject {
    const answer: unknown = this.document.paths?.[path]?.[method]?.responses?.[String(status)];
    if (answer === undefined) throw new Error(`${method} ${path} does not describe ${status}`);
    return answer as oas31.ResponseObject;
  }

  /** Schema of a described response body, built from the document alone. */
  schemaOf({ content = {} }: oas31.ResponseObject): z.ZodType {
    const $defs = this.document.components?.schemas ?? {};
    const text = JSON.stringify({ ...Object.values(content)[0]?.schema, $defs });
    return z.fromJSONSchema(JSON.parse(text.replaceAll("#/components/schemas/", "#/$defs/")));
  }

  async #check(name: string, described: oas31.ResponseObject, answer: Response): Promise<unknown> {
    const fail = (what: string): never => {
      throw new Error(`${name} answered ${answer.status}: ${what}`);
    };
    for (const header of Object.keys(described.headers ?? {})) {
      if (!answer.headers.has(header)) fail(`without the header ${header}`);
    }
    if (described.content === undefined) return undefined;
    const type = answer.headers.get("content-type")?.split(";")[0] ?? "nothing";
    if (!(type in described.content)) fail(`with ${type}`);
    const body: unknown = await answer.json();
    const { error } = this.schemaOf(described).safeParse(body);
    if (error !== undefined) fail(error.message);
    const kind = answer.ok ? "" : problemSchema.parse(body).type;
    if (!described.description.includes(kind)) fail(`with a problem of another kind: ${kind}`);
    return body;
  }
}
