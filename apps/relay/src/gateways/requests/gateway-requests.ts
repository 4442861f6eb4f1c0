/** Requests to gateways of other protocols: the key stands in a header, or in the path. */
import type { Request, RequestHandler, Response } from "express";
import { Refusal } from "../../platform/errors/problems.ts";
import type { GatewayName } from "../../platform/gateway-names.ts";
import { readBearer } from "../../platform/http/reading.ts";
import type { Grant, RobotRegistry } from "../../robots/registry.ts";
import { readIntroduction } from "./script-requests.ts";

/**
 * Authorises a request to a gateway: a key in the header takes precedence over one in the path.
 * @param client name of the gateway in the list of scripts, such as "MCP"
 * @throws Refusal with the same errors as `RobotRegistry.authorise`
 */
export async function authoriseGateway(
  registry: RobotRegistry,
  request: Request<{ id: string; key?: string }>,
  response: Response,
  client: string,
): Promise<Grant> {
  const { id, key: pathKey } = request.params;
  const key = readBearer(request);
  const introduction = { ...readIntroduction(request), client };
  const grant =
    key === null && pathKey !== undefined
      ? await registry.authorise(id, pathKey, "read", introduction, "url")
      : await registry.authorise(id, key, "read", introduction);
  const markAnswered = grant.robot.received(grant.caller);
  response.once("close", markAnswered);
  // The client may have disconnected during authorisation.
  if (response.closed) markAnswered();
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
