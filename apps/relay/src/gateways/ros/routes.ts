/** Ordinary requests to the URL of the ROS gateway, which is a WebSocket. */
import { Router } from "express";
import { Refusal } from "../../platform/errors/problems.ts";
import type { GatewayName } from "../../platform/gateway-names.ts";
import { gatewayDisabled } from "../requests/gateway-requests.ts";

/** @param gateways those that the operator has not switched off */
export function rosRoutes(gateways: readonly GatewayName[]): Router {
  const router = Router();
  const paths = ["/r/:id/ros", "/r/:id/ros/:key"];
  if (!gateways.includes("ros")) return router.all(paths, gatewayDisabled("ros"));
  return router.all(paths, () => {
    throw new Refusal(
      "bad-request",
      "This is the URL of a WebSocket for ROS clients. Connect to it with ws:// or wss://.",
    );
  });
}
