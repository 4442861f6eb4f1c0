/** Requests to gateways of other protocols: the key stands in a header, or in the path. */
import type { Request, RequestHandler, Response } from "express";
import { Refusal } from "../../platform/errors/problems.ts";
import type { GatewayName } from "@corridor/protocol";
import { onClose } from "../../platform/http/on-close.ts";
import { readBearer } from "../../platform/http/reading.ts";
import type { Verb } from "../../robots/access/callers.ts";
import type { Grant, RobotRegistry } from "../../robots/registry.ts";
import type { PortConnection } from "../../robots/relay-port.ts";
import type { StoredKey } from "../../commands/robot-step.ts";
import { readIntroduction } from "./script-requests.ts";

/** The connection of a client that follows a robot within one request: it reads everything at once. */
export const requestConnection: PortConnection = {
  transport: "events",
  flow: { sentBytes: 0, takenBytes: 0, isProof: true, ask: () => undefined },
};

/** What a client of a gateway requests, and with which key. */
export interface GatewayClaim {
  /** the robot */
  id: string;
  /** a key that does not stand in the header, which takes precedence; null: none */
  key: string | null;
  /** "url" if `key` stands in the path of the URL, where only such keys are accepted */
  use: StoredKey["use"];
  verb: Verb;
  /** name of the gateway in the list of scripts, such as "MCP" */
  client: string;
}

/**
 * Authorises a request to a gateway.
 * @throws Refusal with the same errors as `RobotRegistry.authorise`
 */
export async function authoriseGateway(
  registry: RobotRegistry,
  request: Request,
  response: Response,
  { id, key, use, verb, client }: GatewayClaim,
): Promise<Grant> {
  const introduction = { ...readIntroduction(request), client };
  const bearer = readBearer(request);
  const grant =
    bearer === null
      ? await registry.authorise(id, key, verb, introduction, use)
      : await registry.authorise(id, bearer, verb, introduction);
  const markAnswered = grant.robot.received(grant.caller);
  onClose(response, markAnswered);
  return grant;
}

/** A request to a gateway that the operator has switched off. */
export function gatewayDisabled(name: GatewayName): Refusal {
  return new Refusal(
    "gateway-disabled",
    `This service has no gateway '${name}'. Its operator switches gateways on with the setting GATEWAYS.`,
  );
}

export function refuseDisabled(name: GatewayName): RequestHandler {
  return () => {
    throw gatewayDisabled(name);
  };
}
