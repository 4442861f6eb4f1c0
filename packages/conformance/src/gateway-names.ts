/** Gateways: endpoints of a host for other protocols, described in docs/interoperability.md. */
export const gatewayNames = ["ros", "mcp", "soap"] as const;
export type GatewayName = (typeof gatewayNames)[number];
