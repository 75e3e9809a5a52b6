// Moves axis 1 and waits until it has arrived.
using System;
using gts;

class Host
{
    const int InMotion = 0x400; // bit 10 of the status word

    // Ends the program if the card has refused a command.
    static void Accepted(string command, short code)
    {
        if (code == 0) return;
        Console.Error.WriteLine(command + ": the card answers " + code);
        Environment.Exit(1);
    }

    static void Main()
    {
        mc.TTrapPrm trap = new mc.TTrapPrm();
        int status;
        uint clock;
        double position;

        Accepted("GT_Open", mc.GT_Open(0, 1));
        Accepted("GT_AxisOn", mc.GT_AxisOn(1));
        Accepted("GT_PrfTrap", mc.GT_PrfTrap(1));
        trap.acc = 0.25;
        trap.dec = 0.25;
        Accepted("GT_SetTrapPrm", mc.GT_SetTrapPrm(1, ref trap));
        Accepted("GT_SetPos", mc.GT_SetPos(1, 50000));
        Accepted("GT_SetVel", mc.GT_SetVel(1, 50));
        Accepted("GT_Update", mc.GT_Update(1));
        do
        {
            Accepted("GT_GetSts", mc.GT_GetSts(1, out status, 1, out clock));
        } while ((status & InMotion) != 0);
        Accepted("GT_GetPrfPos", mc.GT_GetPrfPos(1, out position, 1, out clock));
        Console.WriteLine("at " + position + " after " + clock + " ms");
        Accepted("GT_Close", mc.GT_Close());
    }
}
